//! Small vectors of lanes: sixteen points, directions or colours at a time, and the matrix that moves them.

use super::float::IntoF32;
use super::mask::Selectable;
use super::plain::lane_op;
use super::{F32, Lanes, Mask};
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// Sixteen pairs.
#[derive(Clone, Copy)]
#[expect(missing_docs, reason = "the coordinates")]
pub struct Vec2<L: Lanes> {
    pub x: F32<L>,
    pub y: F32<L>,
}

/// Sixteen points or directions.
#[derive(Clone, Copy)]
#[expect(missing_docs, reason = "the coordinates")]
pub struct Vec3<L: Lanes> {
    pub x: F32<L>,
    pub y: F32<L>,
    pub z: F32<L>,
}

/// Sixteen homogeneous points.
#[derive(Clone, Copy)]
#[expect(missing_docs, reason = "the coordinates")]
pub struct Vec4<L: Lanes> {
    pub x: F32<L>,
    pub y: F32<L>,
    pub z: F32<L>,
    pub w: F32<L>,
}

/// Sixteen colours: linear light; alpha 1 is opaque.
#[derive(Clone, Copy)]
#[expect(missing_docs, reason = "the channels")]
pub struct Rgba<L: Lanes> {
    pub r: F32<L>,
    pub g: F32<L>,
    pub b: F32<L>,
    pub a: F32<L>,
}

macro_rules! vector {
    ($name:ident { $($c:ident),+ }) => {
        impl<L: Lanes> Add for $name<L> {
            type Output = Self;
            #[inline(always)]
            fn add(self, rhs: Self) -> Self {
                Self { $($c: self.$c + rhs.$c),+ }
            }
        }

        impl<L: Lanes> AddAssign for $name<L> {
            #[inline(always)]
            fn add_assign(&mut self, rhs: Self) {
                *self = *self + rhs;
            }
        }

        impl<L: Lanes> Sub for $name<L> {
            type Output = Self;
            #[inline(always)]
            fn sub(self, rhs: Self) -> Self {
                Self { $($c: self.$c - rhs.$c),+ }
            }
        }

        impl<L: Lanes> Mul for $name<L> {
            type Output = Self;
            #[inline(always)]
            fn mul(self, rhs: Self) -> Self {
                Self { $($c: self.$c * rhs.$c),+ }
            }
        }

        impl<L: Lanes> Mul<F32<L>> for $name<L> {
            type Output = Self;
            #[inline(always)]
            fn mul(self, rhs: F32<L>) -> Self {
                Self { $($c: self.$c * rhs),+ }
            }
        }

        impl<L: Lanes> Mul<f32> for $name<L> {
            type Output = Self;
            #[inline(always)]
            fn mul(self, rhs: f32) -> Self {
                Self { $($c: self.$c * rhs),+ }
            }
        }

        impl<L: Lanes> Div<F32<L>> for $name<L> {
            type Output = Self;
            #[inline(always)]
            fn div(self, rhs: F32<L>) -> Self {
                Self { $($c: self.$c / rhs),+ }
            }
        }

        impl<L: Lanes> Div<f32> for $name<L> {
            type Output = Self;
            #[inline(always)]
            fn div(self, rhs: f32) -> Self {
                Self { $($c: self.$c / rhs),+ }
            }
        }

        impl<L: Lanes> Neg for $name<L> {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self { $($c: -self.$c),+ }
            }
        }

        impl<L: Lanes> Selectable<L> for $name<L> {
            #[inline(always)]
            fn select(mask: Mask<L>, yes: Self, no: Self) -> Self {
                Self { $($c: mask.select(yes.$c, no.$c)),+ }
            }
        }

        impl<L: Lanes> $name<L> {
            /// `self + t * (other - self)`, per component: `self` at 0.
            #[inline(always)]
            pub fn mix(self, other: Self, t: F32<L>) -> Self {
                Self { $($c: self.$c.mix(other.$c, t)),+ }
            }
        }
    };
}

vector!(Vec2 { x, y });
vector!(Vec3 { x, y, z });
vector!(Vec4 { x, y, z, w });
vector!(Rgba { r, g, b, a });

impl<L: Lanes> Vec2<L> {
    /// The scalar product.
    #[inline(always)]
    pub fn dot(self, o: Self) -> F32<L> {
        self.x * o.x + self.y * o.y
    }
}

impl<L: Lanes> Vec3<L> {
    #[inline(always)]
    fn token(self) -> L {
        self.x.token()
    }

    /// The scalar product.
    #[inline(always)]
    pub fn dot(self, o: Self) -> F32<L> {
        let a = self;
        lane_op!(a.token(), (a: Vec3<L>, o: Vec3<L>) -> F32<L> = (a.x * o.x + a.y * o.y) + a.z * o.z)
    }

    /// The vector product, right-handed.
    #[inline(always)]
    pub fn cross(self, o: Self) -> Self {
        let a = self;
        lane_op!(a.token(), (a: Vec3<L>, o: Vec3<L>) -> Vec3<L> = Vec3 {
            x: a.y * o.z - a.z * o.y,
            y: a.z * o.x - a.x * o.z,
            z: a.x * o.y - a.y * o.x,
        })
    }

    /// The length.
    #[inline(always)]
    pub fn length(self) -> F32<L> {
        self.dot(self).sqrt()
    }

    /// Unit length, same direction; the zero vector stays zero.
    #[inline(always)]
    pub fn normalize(self) -> Self {
        let a = self;
        // The smallest normal float keeps 1/sqrt finite, and times zero it is zero.
        lane_op!(a.token(), (a: Vec3<L>) -> Vec3<L> = a * (1.0 / a.dot(a).max(f32::MIN_POSITIVE).sqrt()))
    }

    /// A homogeneous point or direction.
    #[inline(always)]
    pub fn extend(self, w: impl IntoF32<L>) -> Vec4<L> {
        Vec4 { x: self.x, y: self.y, z: self.z, w: w.into_f32(self.token()) }
    }

    /// Read as red, green, blue.
    #[inline(always)]
    pub fn rgba(self, a: impl IntoF32<L>) -> Rgba<L> {
        Rgba { r: self.x, g: self.y, b: self.z, a: a.into_f32(self.token()) }
    }
}

impl<L: Lanes> Vec4<L> {
    /// Without w.
    #[inline(always)]
    pub fn xyz(self) -> Vec3<L> {
        Vec3 { x: self.x, y: self.y, z: self.z }
    }
}

impl<L: Lanes> Rgba<L> {
    /// Red, green and blue as a vector.
    #[inline(always)]
    pub fn rgb(self) -> Vec3<L> {
        Vec3 { x: self.r, y: self.g, z: self.b }
    }
}

/// A 4x4 matrix for column vectors, stored by columns: `columns[3]` is the translation.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Mat4 {
    /// The images of the three axes and of the origin.
    pub columns: [[f32; 4]; 4],
}

impl Mat4 {
    /// Leaves points where they are.
    pub const IDENTITY: Self =
        Self { columns: [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]] };

    /// Moves sixteen points (w = 1).
    #[inline(always)]
    pub fn transform_point<L: Lanes>(&self, l: L, p: Vec3<L>) -> Vec4<L> {
        let matrix = self;
        lane_op!(l, (l: L, matrix: &Mat4, p: Vec3<L>) -> Vec4<L> = {
            let [x, y, z, o] = matrix.columns;
            Vec4 {
                x: ((p.x * x[0] + p.y * y[0]) + p.z * z[0]) + l.f32(o[0]),
                y: ((p.x * x[1] + p.y * y[1]) + p.z * z[1]) + l.f32(o[1]),
                z: ((p.x * x[2] + p.y * y[2]) + p.z * z[2]) + l.f32(o[2]),
                w: ((p.x * x[3] + p.y * y[3]) + p.z * z[3]) + l.f32(o[3]),
            }
        })
    }

    /// Turns sixteen directions (w = 0).
    #[inline(always)]
    pub fn transform_vector<L: Lanes>(&self, v: Vec3<L>) -> Vec3<L> {
        let matrix = self;
        lane_op!(v.x.token(), (matrix: &Mat4, v: Vec3<L>) -> Vec3<L> = {
            let [x, y, z, _] = matrix.columns;
            Vec3 {
                x: (v.x * x[0] + v.y * y[0]) + v.z * z[0],
                y: (v.x * x[1] + v.y * y[1]) + v.z * z[1],
                z: (v.x * x[2] + v.y * y[2]) + v.z * z[2],
            }
        })
    }
}
