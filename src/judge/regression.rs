//! Regression of one quantity on another.

/// Sums of a regression of y on x.
#[derive(Debug, Clone, Copy)]
pub(super) struct Regression {
    pub count: f64,
    pub x: f64,
    pub y: f64,
    pub xx: f64,
    pub xy: f64,
    pub yy: f64,
}

impl Regression {
    pub const NONE: Self = Self { count: 0.0, x: 0.0, y: 0.0, xx: 0.0, xy: 0.0, yy: 0.0 };

    pub fn add(&mut self, x: f64, y: f64) {
        self.count += 1.0;
        self.x += x;
        self.y += y;
        self.xx += x * x;
        self.xy += x * y;
        self.yy += y * y;
    }

    /// That of the points of both.
    pub fn with(&self, other: &Self) -> Self {
        Self {
            count: self.count + other.count,
            x: self.x + other.x,
            y: self.y + other.y,
            xx: self.xx + other.xx,
            xy: self.xy + other.xy,
            yy: self.yy + other.yy,
        }
    }

    /// Standard deviation of x, slope, correlation.
    pub fn figures(&self) -> (f64, f64, f64) {
        let n = self.count;
        let (xx, yy) = (self.xx / n - (self.x / n) * (self.x / n), self.yy / n - (self.y / n) * (self.y / n));
        let xy = self.xy / n - self.x / n * self.y / n;
        (xx.max(0.0).sqrt(), xy / xx, xy / (xx * yy).max(0.0).sqrt())
    }
}
