//! The classical fourth-order Runge-Kutta step.

/// Linear equations x' = A(u) x + b(u) over an interval, u = 0..1.
pub(super) trait LinearEquations: Sized {
    /// A and b at an instant.
    type Coefficients;

    /// x' there.
    fn rate(&self, coefficients: &Self::Coefficients) -> Self;

    /// x + `rate` `t`
    fn plus(&self, rate: &Self, t: f64) -> Self;

    /// x after a step of length `t` [s], from the coefficients at its start, middle and end.
    #[inline]
    fn after(&self, [start, middle, end]: &[Self::Coefficients; 3], t: f64) -> Self {
        let k1 = self.rate(start);
        let k2 = self.plus(&k1, 0.5 * t).rate(middle);
        let k3 = self.plus(&k2, 0.5 * t).rate(middle);
        let k4 = self.plus(&k3, t).rate(end);
        let k = k1.plus(&k2.plus(&k3, 1.0), 2.0).plus(&k4, 1.0);
        self.plus(&k, t / 6.0)
    }
}
