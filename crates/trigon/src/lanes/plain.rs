//! Operations at the plain level are functions.
//!
//! At a SIMD level an operation on sixteen lanes is one to four instructions, inlined. At the plain level it is sixteen
//! scalar ones and the copies of its operands; inlined everywhere, they made its kernels ten times as large as the
//! others and the slowest of all to compile, for a level that is there to check the others and for CPUs without vectors.

/// An operation on lanes, inlined at SIMD levels and called at the plain one:
/// `lane_op!(l, (a: F32<L>, b: F32<L>) -> F32<L> = F32(a.0 + b.0))`.
///
/// The operands are variables of these names; `L` stands for the level, also where the caller calls it otherwise.
macro_rules! lane_op {
    ($l:expr, ($($operand:ident: $type:ty),+) -> $out:ty = $body:expr) => {{
        #[inline(never)]
        fn plain<L: $crate::lanes::Lanes>($($operand: $type),+) -> $out {
            $body
        }
        if $crate::lanes::token::is_plain($l) { plain($($operand),+) } else { $body }
    }};
}

pub(super) use lane_op;
