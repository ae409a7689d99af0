//! Random inputs over a stretch. Each counts as the straight line that has the same integral and the same first moment, as these two
//! determine velocity and position at the end.

use crate::base::math::exp_m1;

/// A straight line over a stretch: its mean and its change from start to end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    pub mean: f64,
    pub change: f64,
}

/// The covariance of mean and change of a random line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    mean: f64,
    both: f64,
    change: f64,
}

impl Line {
    pub const NONE: Self = Self { mean: 0.0, change: 0.0 };

    /// The line of an integral and a double integral over unit time.
    fn of_integrals(single: f64, double: f64) -> Self {
        Self { mean: single, change: 6.0 * single - 12.0 * double }
    }

    fn scaled(self, factor: f64) -> Self {
        Self { mean: self.mean * factor, change: self.change * factor }
    }

    /// Its values at the start, in the middle and at the end.
    pub fn at_nodes(&self) -> [f64; 3] {
        [self.mean - 0.5 * self.change, self.mean, self.mean + 0.5 * self.change]
    }
}

impl Spread {
    pub const NONE: Self = Self { mean: 0.0, both: 0.0, change: 0.0 };

    /// White noise of this density over `t` \[s\].
    pub fn of_white_noise(density: f64, t: f64) -> Self {
        let mean = density * density / t;
        Self { mean, both: 0.0, change: 12.0 * mean }
    }

    fn scaled(self, factor: f64) -> Self {
        Self { mean: self.mean * factor, both: self.both * factor, change: self.change * factor }
    }

    pub fn add(&mut self, other: &Self) {
        self.mean += other.mean;
        self.both += other.both;
        self.change += other.change;
    }

    /// Variance of the mean.
    pub fn of_mean(&self) -> f64 {
        self.mean
    }

    pub fn is_none(&self) -> bool {
        *self == Self::NONE
    }

    /// Two lines whose sum, each times a draw of its own, has this covariance.
    pub fn lines(&self) -> [Line; 2] {
        let mean = self.mean.sqrt();
        let change = if mean > 0.0 { self.both / mean } else { 0.0 };
        let own = (self.change - change * change).max(0.0).sqrt();
        [Line { mean, change }, Line { mean: 0.0, change: own }]
    }
}

/// A process over a stretch. Its value at the end is `decay` β + `diffusion` w, with its value β at the start and a draw w. Its line
/// is `of_start` β + `of_draw` w and a rest, which is independent of both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Advance {
    pub decay: f64,
    pub diffusion: f64,
    pub of_start: Line,
    pub of_draw: Line,
    pub rest: Spread,
}

/// Covariance of the end b of a process that starts at 0, of its integral and of its double integral, over unit time.
struct Moments {
    end: f64,
    end_single: f64,
    end_double: f64,
    single: f64,
    single_double: f64,
    double: f64,
}

impl Moments {
    /// The standard deviation of the end, the line for an end of one deviation, and the rest.
    fn split(&self) -> (f64, Line, Spread) {
        let end = self.end.sqrt();
        let of_draw = Line::of_integrals(self.end_single / end, self.end_double / end);
        let rest = Spread {
            mean: (self.single - of_draw.mean * of_draw.mean).max(0.0),
            both: 6.0 * self.single - 12.0 * self.single_double - of_draw.mean * of_draw.change,
            change: (36.0 * self.single
                - 144.0 * (self.single_double - self.double)
                - of_draw.change * of_draw.change)
                .max(0.0),
        };
        (end, of_draw, rest)
    }
}

impl Advance {
    /// A constant, or a process that does not move.
    pub fn still(size: f64) -> Self {
        let of_start = Line { mean: size, change: 0.0 };
        Self { decay: 1.0, diffusion: 0.0, of_start, of_draw: Line::NONE, rest: Spread::NONE }
    }

    /// A Gauss-Markov process of unit variance and size `sigma`, over `x` correlation times.
    pub fn markov(x: f64, sigma: f64) -> Self {
        let moments = Moments {
            end: exponential_rest(x, [0.0, 0.0, -1.0], 1, 0),
            end_single: exponential_rest(x, [-2.0, 0.0, 1.0], 2, 1),
            end_double: exponential_rest(x, [0.0, 2.0, -1.0], 3, 2),
            single: exponential_rest(x, [4.0, 0.0, -1.0], 3, 2),
            single_double: exponential_rest(x, [-2.0, -2.0, 1.0], 4, 3),
            double: exponential_rest(x, [0.0, 4.0, -1.0], 5, 4),
        };
        let (diffusion, of_draw, rest) = moments.split();
        // ∫e^(-x u) du and its double integral.
        let of_start = Line::of_integrals(
            -exponential_rest(x, [1.0, 0.0, 0.0], 1, 1),
            exponential_rest(x, [1.0, 0.0, 0.0], 2, 2),
        );
        Self {
            decay: 1.0 + exp_m1(-x),
            diffusion,
            of_start: of_start.scaled(sigma),
            of_draw: of_draw.scaled(sigma),
            rest: rest.scaled(sigma * sigma),
        }
    }

    /// A random walk that has the standard deviation `start` and moves by `step`.
    pub fn walk(start: f64, step: f64) -> Self {
        let end = (start * start + step * step).sqrt();
        // A walk whose variance underflows is none.
        if end == 0.0 {
            return Self::still(0.0);
        }
        let moments = Moments {
            end: 1.0,
            end_single: 1.0 / 2.0,
            end_double: 1.0 / 6.0,
            single: 1.0 / 3.0,
            single_double: 1.0 / 8.0,
            double: 1.0 / 20.0,
        };
        let (_, of_draw, rest) = moments.split();
        Self {
            decay: start / end,
            diffusion: step / end,
            of_start: Line { mean: start, change: 0.0 },
            of_draw: of_draw.scaled(step),
            rest: rest.scaled(step * step),
        }
    }
}

/// a e^-x - b x e^-x + c e^-2x without its terms below x^`first`, divided by x^`power`. Its term of order n is
/// (a + b n + c 2ⁿ) (-x)ⁿ/n!. The moments of a Gauss-Markov process over x correlation times have this form (Singer 1970).
fn exponential_rest(x: f64, [a, b, c]: [f64; 3], first: i32, power: i32) -> f64 {
    // (-x)ⁿ/n!, 2ⁿ, and the sums below `first` and from there on.
    let (mut term, mut power_of_2, mut sums) = (1.0, 1.0, [0.0; 2]);
    for n in 0..first + 20 {
        sums[usize::from(n >= first)] += (a + b * f64::from(n) + c * power_of_2) * term;
        term *= -x / f64::from(n + 1);
        power_of_2 *= 2.0;
    }
    // Below 1 the closed form loses digits by cancellation; there the terms beyond are below 1e-17 of the first.
    let rest = if x < 1.0 {
        sums[1]
    } else {
        let decay = 1.0 + exp_m1(-x);
        (a - b * x) * decay + c * decay * decay - sums[0]
    };
    (0..power).fold(rest, |rest, _| rest / x)
}
