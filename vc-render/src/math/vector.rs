//! Vectors of three numbers.

/// An array of three values by index. An array's own `map` is not always inlined, and is then not vectorized
/// with the loop around it.
#[inline(always)]
pub(crate) fn three<T>(part: impl Fn(usize) -> T) -> [T; 3] {
    [part(0), part(1), part(2)]
}

/// A vector times a scalar.
#[inline(always)]
pub(crate) fn scaled(v: [f32; 3], by: f32) -> [f32; 3] {
    [v[0] * by, v[1] * by, v[2] * by]
}

/// Normalizes a vector; a zero vector becomes the upward one.
#[inline(always)]
pub(crate) fn unit(v: [f32; 3]) -> [f32; 3] {
    let square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    let over = 1.0 / square.sqrt();
    if over.is_finite() { scaled(v, over) } else { [0.0, 0.0, 1.0] }
}

/// The scalar product.
#[inline(always)]
pub(crate) fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The axis along which a vector has its largest component, by absolute value.
#[inline(always)]
pub(crate) fn longest(v: [f32; 3]) -> u8 {
    let [x, y, z] = v.map(f32::abs);
    let others = if y >= z { 1 } else { 2 };
    if x >= y && x >= z { 0 } else { others }
}

/// The cross product: perpendicular to both vectors, as long as the area of the parallelogram between them.
#[inline(always)]
pub(crate) fn cross(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The volume spanned by three vectors (their triple product); negative if they are left-handed.
pub(crate) fn volume(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> f64 {
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}
