//! The operations of [`Two`](crate::math::Two): SSE2 on x86-64, where every processor has it, and plain numbers elsewhere.

#[cfg(not(target_arch = "x86_64"))]
pub(crate) use portable::*;
#[cfg(target_arch = "x86_64")]
pub(crate) use sse2::*;

#[cfg(target_arch = "x86_64")]
mod sse2 {
    use core::arch::x86_64::*;

    pub type Register = __m128d;

    macro_rules! instructions {
        ($($name:ident($($argument:ident: $type:ty),*) -> $result:ty = $value:expr;)*) => {$(
            #[inline(always)]
            pub fn $name($($argument: $type),*) -> $result {
                // SAFETY: every processor of this kind has SSE2.
                unsafe { $value }
            }
        )*};
    }

    instructions! {
        new(first: f64, second: f64) -> Register = _mm_set_pd(second, first);
        first(x: Register) -> f64 = _mm_cvtsd_f64(x);
        second(x: Register) -> f64 = _mm_cvtsd_f64(_mm_unpackhi_pd(x, x));
        firsts(x: Register, y: Register) -> Register = _mm_unpacklo_pd(x, y);
        seconds(x: Register, y: Register) -> Register = _mm_unpackhi_pd(x, y);
        exchanged(x: Register) -> Register = _mm_shuffle_pd::<1>(x, x);
        add(x: Register, y: Register) -> Register = _mm_add_pd(x, y);
        sub(x: Register, y: Register) -> Register = _mm_sub_pd(x, y);
        mul(x: Register, y: Register) -> Register = _mm_mul_pd(x, y);
        div(x: Register, y: Register) -> Register = _mm_div_pd(x, y);
        sqrt(x: Register) -> Register = _mm_sqrt_pd(x);
        min(x: Register, y: Register) -> Register = _mm_min_pd(x, y);
        less(x: Register, y: Register) -> Register = _mm_cmplt_pd(x, y);
        at_most(x: Register, y: Register) -> bool = _mm_movemask_pd(_mm_cmpnle_pd(x, y)) == 0;
        bitand(x: Register, y: Register) -> Register = _mm_and_pd(x, y);
        bitxor(x: Register, y: Register) -> Register = _mm_xor_pd(x, y);
        and_not(x: Register, y: Register) -> Register = _mm_andnot_pd(x, y);
    }
}

#[cfg(not(target_arch = "x86_64"))]
mod portable {
    pub type Register = [f64; 2];

    macro_rules! of_each {
        ($($name:ident($($argument:ident),*) = $value:expr;)*) => {$(
            #[inline(always)]
            pub fn $name($($argument: Register),*) -> Register {
                let of = |$($argument: f64),*| -> f64 { $value };
                [of($($argument[0]),*), of($($argument[1]),*)]
            }
        )*};
    }

    of_each! {
        add(x, y) = x + y;
        sub(x, y) = x - y;
        mul(x, y) = x * y;
        div(x, y) = x / y;
        sqrt(x) = x.sqrt();
        min(x, y) = if x < y { x } else { y };
        less(x, y) = f64::from_bits(u64::from(x < y).wrapping_neg());
        bitand(x, y) = f64::from_bits(x.to_bits() & y.to_bits());
        bitxor(x, y) = f64::from_bits(x.to_bits() ^ y.to_bits());
        and_not(x, y) = f64::from_bits(!x.to_bits() & y.to_bits());
    }

    #[inline(always)]
    pub fn new(first: f64, second: f64) -> Register {
        [first, second]
    }

    #[inline(always)]
    pub fn first(x: Register) -> f64 {
        x[0]
    }

    #[inline(always)]
    pub fn second(x: Register) -> f64 {
        x[1]
    }

    #[inline(always)]
    pub fn firsts(x: Register, y: Register) -> Register {
        [x[0], y[0]]
    }

    #[inline(always)]
    pub fn seconds(x: Register, y: Register) -> Register {
        [x[1], y[1]]
    }

    #[inline(always)]
    pub fn exchanged(x: Register) -> Register {
        [x[1], x[0]]
    }

    #[inline(always)]
    pub fn at_most(x: Register, y: Register) -> bool {
        x[0] <= y[0] && x[1] <= y[1]
    }
}
