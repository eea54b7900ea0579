//! The binary container: a header, a chunk of JSON, a chunk of binary data.

use super::GltfError;
use super::document::Document;

const MAGIC: &[u8] = b"glTF";
const JSON: u32 = u32::from_le_bytes(*b"JSON");
const BIN: u32 = u32::from_le_bytes(*b"BIN\0");

/// Assembles the file.
pub(super) fn join(document: &Document, mut bytes: Vec<u8>) -> Result<Vec<u8>, GltfError> {
    let mut json = serde_json::to_vec(document).map_err(|e| GltfError::Json(e.to_string()))?;
    pad(&mut json, b' ');
    pad(&mut bytes, 0);
    let chunks = [(JSON, json), (BIN, bytes)];
    let kept = chunks.iter().filter(|(_, content)| !content.is_empty());
    let length = 12 + kept.clone().map(|(_, content)| 8 + content.len()).sum::<usize>();
    let length = u32::try_from(length).map_err(|_| GltfError::TooLarge)?;
    let mut file = [MAGIC, &2u32.to_le_bytes(), &length.to_le_bytes()].concat();
    for (kind, content) in kept {
        file.extend((content.len() as u32).to_le_bytes());
        file.extend(kind.to_le_bytes());
        file.extend(content);
    }
    Ok(file)
}

fn pad(bytes: &mut Vec<u8>, with: u8) {
    bytes.resize(bytes.len().next_multiple_of(4), with);
}

/// The JSON and the binary data of a file; a text file has no binary data.
pub(super) fn split(file: &[u8]) -> Result<(Document, &[u8]), GltfError> {
    let (json, bytes) = if file.starts_with(MAGIC) { chunks(file)? } else { (file, &[][..]) };
    // Some programs write a byte order mark, or pad the text with zeros.
    let json = json.strip_prefix(b"\xef\xbb\xbf").unwrap_or(json);
    let end = json.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1);
    let json = &json[..end];
    if !json.trim_ascii_start().starts_with(b"{") {
        return Err(GltfError::NotGltf("it starts with neither `glTF` nor `{`"));
    }
    let document: Document = serde_json::from_slice(json).map_err(|e| GltfError::Json(e.to_string()))?;
    if !document.asset.version.starts_with("2.") {
        return Err(GltfError::NotGltf("its version is not 2"));
    }
    Ok((document, bytes))
}

fn chunks(file: &[u8]) -> Result<(&[u8], &[u8]), GltfError> {
    if word(file, 4) != Some(2) {
        return Err(GltfError::NotGltf("its container's version is not 2"));
    }
    let (mut json, mut bytes, mut at) = (None, None, 12);
    while let (Some(length), Some(kind)) = (word(file, at), word(file, at + 4)) {
        let end = (at + 8).checked_add(length as usize).ok_or(GltfError::NotGltf("a chunk is too long"))?;
        let content = file.get(at + 8..end).ok_or(GltfError::NotGltf("it is cut off"))?;
        match kind {
            JSON => json = json.or(Some(content)),
            BIN => bytes = bytes.or(Some(content)),
            _ => {}
        }
        at = end;
    }
    Ok((json.ok_or(GltfError::NotGltf("it has no JSON"))?, bytes.unwrap_or_default()))
}

fn word(file: &[u8], at: usize) -> Option<u32> {
    let bytes = file.get(at..at.checked_add(4)?)?;
    Some(u32::from_le_bytes(bytes.try_into().ok()?))
}
