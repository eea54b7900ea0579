//! NumPy array files.

use crate::RenderError;

/// A number type that NumPy has, for [`npy`]: `f32`, `u32`, `u16` and `u8`, and nodes by their numbers.
pub trait NpyNumber: Copy {
    /// NumPy's name of the type, such as `<f4`.
    const NAME: &'static str;
    /// Appends its bytes, the lowest first.
    fn bytes(self, out: &mut Vec<u8>);
}

macro_rules! numbers {
    ($($number:ty: $name:literal),*) => {
        $(impl NpyNumber for $number {
            const NAME: &'static str = $name;
            fn bytes(self, out: &mut Vec<u8>) {
                out.extend(self.to_le_bytes());
            }
        })*
    };
}

numbers!(f32: "<f4", u32: "<u4", u16: "<u2", u8: "|u1");

impl NpyNumber for vc_graph::NodeId {
    const NAME: &'static str = u32::NAME;
    fn bytes(self, out: &mut Vec<u8>) {
        self.0.bytes(out);
    }
}

/// Encodes an array as a file for `numpy.load`, format 1.0. `shape` is the length along each axis, the slowest
/// first. One pass over the numbers; the header is a multiple of 64 bytes.
///
/// # Errors
/// [`RenderError::BadShape`] if the count of numbers is not the product of the lengths.
///
/// ```
/// let depth = [1.0_f32, 2.0, f32::INFINITY, 4.0];
/// let file = vc_render::format::npy(&depth, &[2, 2])?;
/// assert!(file.starts_with(b"\x93NUMPY\x01\x00"));
/// assert_eq!(file.len() % 64, 16); // a header of whole blocks, and four numbers
/// assert!(vc_render::format::npy(&depth, &[2, 3]).is_err());
/// let instance = [vc_graph::NodeId(7), vc_graph::NodeId(9)];
/// assert_eq!(vc_render::format::npy(&instance, &[2])?, vc_render::format::npy(&[7_u32, 9], &[2])?);
/// # Ok::<(), vc_render::RenderError>(())
/// ```
pub fn npy<T: NpyNumber>(numbers: &[T], shape: &[usize]) -> Result<Vec<u8>, RenderError> {
    if shape.iter().try_fold(1_usize, |all, length| all.checked_mul(*length)) != Some(numbers.len()) {
        return Err(RenderError::BadShape { numbers: numbers.len(), shape: shape.to_vec() });
    }
    let lengths: String = shape.iter().map(|n| format!("{n},")).collect();
    let mut header = format!("{{'descr': '{}', 'fortran_order': False, 'shape': ({lengths}), }}", T::NAME);
    // The header and the bytes before it fill blocks of 64 bytes.
    let length = (header.len() + 11).next_multiple_of(64) - 10;
    while header.len() + 1 < length {
        header.push(' ');
    }
    header.push('\n');
    let mut file = b"\x93NUMPY\x01\x00".to_vec();
    file.extend((header.len() as u16).to_le_bytes());
    file.extend(header.bytes());
    numbers.iter().for_each(|n| n.bytes(&mut file));
    Ok(file)
}
