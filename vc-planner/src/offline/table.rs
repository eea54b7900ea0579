//! Transitions as a Parquet file: a row for each step and a row group for each episode.

use std::io::Write;
use std::sync::Arc;

use parquet::basic::Encoding;
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::parser::parse_message_type;
use vc_graph::{SceneGraph, Scope};

use crate::{Fault, Trajectory, Transition};

/// The columns. The names of the last six are Minari's and Gymnasium's.
const SCHEMA: &str = "message transition {
    required int64 episode;
    required binary task (string);
    required binary goal (string);
    required binary policy (string);
    required int64 seed;
    required int64 step;
    required binary observation (string);
    required binary action (string);
    required double reward;
    required binary next_observation (string);
    required boolean terminated;
    required boolean truncated;
}";

/// The reason why no table was written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TableError {
    /// An episode cannot be replayed from the given initial scene.
    #[error("episode {episode}: {fault}")]
    Episode {
        /// Position in the list, from zero.
        episode: usize,
        /// The fault of the episode.
        #[source]
        fault: Fault,
    },
    /// The file could not be written.
    #[error(transparent)]
    Write(#[from] ParquetError),
}

/// Writes episodes, each with its initial scene, as one Parquet file: a row for each step, with the columns
/// `episode`, `task`, `goal`, `policy`, `seed`, `step`, `observation`, `action`, `reward`, `next_observation`,
/// `terminated` and `truncated`; see [`Transition`]. Texts repeat, so they are stored in dictionaries, without
/// further compression.
///
/// # Errors
/// [`TableError`] if an episode cannot be replayed or the file cannot be written.
pub fn write_parquet<'a>(
    out: impl Write + Send,
    scope: Scope,
    episodes: impl IntoIterator<Item = (&'a Trajectory, &'a SceneGraph)>,
) -> Result<(), TableError> {
    let schema = Arc::new(parse_message_type(SCHEMA)?);
    let properties = WriterProperties::builder().set_encoding(Encoding::PLAIN).set_dictionary_enabled(true).build();
    let mut file = SerializedFileWriter::new(out, schema, Arc::new(properties))?;
    for (episode, (trajectory, initial)) in episodes.into_iter().enumerate() {
        let steps = trajectory.transitions(initial, scope).map_err(|fault| TableError::Episode { episode, fault })?;
        let mut group = file.next_row_group()?;
        write_columns(&mut group, episode, trajectory, &steps)?;
        group.close()?;
    }
    file.close()?;
    Ok(())
}

/// The values of a column.
enum Values {
    Numbers(Vec<i64>),
    Texts(Vec<ByteArray>),
    Reals(Vec<f64>),
    Flags(Vec<bool>),
}

fn write_columns<W: Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    episode: usize,
    trajectory: &Trajectory,
    steps: &[Transition],
) -> Result<(), ParquetError> {
    let header = &trajectory.header;
    let same_number = |n: u64| Values::Numbers(vec![n as i64; steps.len()]);
    let same_text = |text: &str| Values::Texts(vec![ByteArray::from(text); steps.len()]);
    let texts = |of: fn(&Transition) -> &str| Values::Texts(steps.iter().map(|s| ByteArray::from(of(s))).collect());
    let flags = |of: fn(&Transition) -> bool| Values::Flags(steps.iter().map(of).collect());
    let columns = [
        same_number(episode as u64),
        same_text(&header.task),
        same_text(&header.goal.to_string()),
        same_text(&header.policy),
        same_number(header.seed.0),
        Values::Numbers(steps.iter().map(|s| s.step as i64).collect()),
        texts(|s| &s.observation),
        texts(|s| &s.action),
        Values::Reals(steps.iter().map(|s| s.reward).collect()),
        texts(|s| &s.next_observation),
        flags(|s| s.terminated),
        flags(|s| s.truncated),
    ];
    for values in columns {
        let Some(mut column) = group.next_column()? else { break };
        match (column.untyped(), values) {
            (ColumnWriter::Int64ColumnWriter(w), Values::Numbers(v)) => w.write_batch(&v, None, None)?,
            (ColumnWriter::ByteArrayColumnWriter(w), Values::Texts(v)) => w.write_batch(&v, None, None)?,
            (ColumnWriter::DoubleColumnWriter(w), Values::Reals(v)) => w.write_batch(&v, None, None)?,
            (ColumnWriter::BoolColumnWriter(w), Values::Flags(v)) => w.write_batch(&v, None, None)?,
            _ => return Err(ParquetError::General("a column of another type than the schema's".into())),
        };
        column.close()?;
    }
    Ok(())
}
