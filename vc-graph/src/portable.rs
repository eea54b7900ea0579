//! Elementary functions with the same results on every machine.
//!
//! Sums, products and square roots of floats are exact to the last bit everywhere. The standard library's
//! sines, powers and logarithms are those of the platform's C library and differ in the last bit between
//! systems. Everything generated from a seed therefore uses `libm`, which is written in Rust. `clippy.toml`
//! forbids the others.

/// Elementary functions with one result on every machine. Their names are written out, since methods with the
/// standard library's names would be shadowed by its own. Each takes a few nanoseconds.
///
/// ```
/// use vc_graph::portable::Portable;
/// let (sine, cosine) = 0.5_f32.sine_cosine();
/// assert_eq!((sine, cosine), (0.5_f32.sine(), 0.5_f32.cosine()));
/// assert_eq!(2.0_f32.raised(10), 1024.0);
/// ```
pub trait Portable: Copy {
    /// The sine of an angle in radians.
    #[must_use]
    fn sine(self) -> Self;
    /// The cosine of an angle in radians.
    #[must_use]
    fn cosine(self) -> Self;
    /// The tangent of an angle in radians.
    #[must_use]
    fn tangent(self) -> Self;
    /// Sine and cosine of an angle in radians.
    #[must_use]
    fn sine_cosine(self) -> (Self, Self);
    /// The arcsine, radians.
    #[must_use]
    fn arc_sine(self) -> Self;
    /// The arccosine, radians.
    #[must_use]
    fn arc_cosine(self) -> Self;
    /// The arctangent, radians.
    #[must_use]
    fn arc_tangent(self) -> Self;
    /// The angle of the point (`x`, `self`), radians (`atan2`).
    #[must_use]
    fn angle_to(self, x: Self) -> Self;
    /// The number to any power.
    #[must_use]
    fn power(self, exponent: Self) -> Self;
    /// The number to an integer power: products in a fixed order.
    #[must_use]
    fn raised(self, exponent: i32) -> Self;
    /// The exponential function.
    #[must_use]
    fn exponential(self) -> Self;
    /// The natural logarithm.
    #[must_use]
    fn logarithm(self) -> Self;
    /// The cube root.
    #[must_use]
    fn cube_root(self) -> Self;
    /// The square root of the sum of both squares.
    #[must_use]
    fn hypotenuse(self, other: Self) -> Self;
}

macro_rules! portable {
    ($float:ty: $sin:ident $cos:ident $tan:ident $sincos:ident $asin:ident $acos:ident $atan:ident $atan2:ident
     $pow:ident $exp:ident $log:ident $cbrt:ident $hypot:ident) => {
        impl Portable for $float {
            fn sine(self) -> Self {
                libm::$sin(self)
            }
            fn cosine(self) -> Self {
                libm::$cos(self)
            }
            fn tangent(self) -> Self {
                libm::$tan(self)
            }
            fn sine_cosine(self) -> (Self, Self) {
                libm::$sincos(self)
            }
            fn arc_sine(self) -> Self {
                libm::$asin(self)
            }
            fn arc_cosine(self) -> Self {
                libm::$acos(self)
            }
            fn arc_tangent(self) -> Self {
                libm::$atan(self)
            }
            fn angle_to(self, x: Self) -> Self {
                libm::$atan2(self, x)
            }
            fn power(self, exponent: Self) -> Self {
                libm::$pow(self, exponent)
            }
            fn raised(self, exponent: i32) -> Self {
                let product = (0..exponent.unsigned_abs()).fold(1.0, |product, _| product * self);
                if exponent < 0 { 1.0 / product } else { product }
            }
            fn exponential(self) -> Self {
                libm::$exp(self)
            }
            fn logarithm(self) -> Self {
                libm::$log(self)
            }
            fn cube_root(self) -> Self {
                libm::$cbrt(self)
            }
            fn hypotenuse(self, other: Self) -> Self {
                libm::$hypot(self, other)
            }
        }
    };
}

portable!(f32: sinf cosf tanf sincosf asinf acosf atanf atan2f powf expf logf cbrtf hypotf);
portable!(f64: sin cos tan sincos asin acos atan atan2 pow exp log cbrt hypot);
