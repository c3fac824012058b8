//! Elementary functions of single numbers, the same on every machine: for cameras, lights and tables, outside kernels.
//!
//! Angles in radians. They are those of the `libm` crate, a port of musl's: plain arithmetic, errors below 1 ulp
//! (`powf` and `tan` below 2).

/// The sine.
#[must_use]
pub fn sin(x: f32) -> f32 {
    libm::sinf(x)
}

/// The cosine.
#[must_use]
pub fn cos(x: f32) -> f32 {
    libm::cosf(x)
}

/// The tangent.
#[must_use]
pub fn tan(x: f32) -> f32 {
    libm::tanf(x)
}

/// `base` to the power of `exponent`.
#[must_use]
pub fn powf(base: f32, exponent: f32) -> f32 {
    libm::powf(base, exponent)
}

/// The sine in double precision.
#[must_use]
pub fn sin_f64(x: f64) -> f64 {
    libm::sin(x)
}

/// The cosine in double precision.
#[must_use]
pub fn cos_f64(x: f64) -> f64 {
    libm::cos(x)
}

/// The tangent in double precision.
#[must_use]
pub fn tan_f64(x: f64) -> f64 {
    libm::tan(x)
}

/// `base` to the power of `exponent` in double precision.
#[must_use]
pub fn powf_f64(base: f64, exponent: f64) -> f64 {
    libm::pow(base, exponent)
}
