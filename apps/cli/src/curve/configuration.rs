//! The configurations of the matrix: schemes, subsamples and axes.

use sins::Options;
use sins::analysis::recommend::Rung;
use sins::mechanization::{Frame, Scheme};

/// Numbers of subsamples of each scheme. With more than two, the error of the paper's scheme stays the same or grows by 2 %.
const SCHEMES: [(Scheme, std::ops::RangeInclusive<usize>); 3] =
    [(Scheme::Paper, 1..=2), (Scheme::Exact, 1..=5), (Scheme::Polynomial, 1..=5)];

/// Rungs with several updates in a sample. Of all rungs with 2 or 4 updates, only these reached a Pareto front, each on one scene.
const SEVERAL_UPDATES: [Rung; 2] = [
    Rung { scheme: Scheme::Exact, subsamples: 2, updates_per_sample: 2 },
    Rung { scheme: Scheme::Polynomial, subsamples: 4, updates_per_sample: 2 },
];

/// Configuration of the mechanization.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Configuration {
    pub rung: Rung,
    pub frame: Frame,
}

impl Configuration {
    /// Configuration of the paper.
    pub const PAPER: Self = Self {
        rung: Rung { scheme: Scheme::Paper, subsamples: 2, updates_per_sample: 1 },
        frame: Frame::Geographic,
    };

    /// Configuration of `options`.
    pub fn of(options: &Options) -> Self {
        let Options { scheme, subsamples, updates_per_sample, frame, .. } = *options;
        Self { rung: Rung { scheme, subsamples, updates_per_sample }, frame }
    }

    /// Configurations of the matrix, ordered by frame, scheme and subsamples. Configurations with several updates are last.
    pub fn all() -> Vec<Self> {
        let mut all = Vec::new();
        for frame in [Frame::EarthFixed, Frame::Geographic] {
            for (scheme, range) in SCHEMES {
                for subsamples in range {
                    all.push(Self { rung: Rung { scheme, subsamples, updates_per_sample: 1 }, frame });
                }
            }
        }
        all.extend(SEVERAL_UPDATES.map(|rung| Self { rung, frame: Frame::default() }));
        all
    }

    /// Whether the configuration is of the family that a user chooses from: the library's own schemes, in axes that are not
    /// singular at a pole.
    pub fn is_default_family(&self) -> bool {
        self.frame == Frame::EarthFixed && self.rung.scheme != Scheme::Paper
    }

    /// `base` with the scheme and the axes of this configuration.
    pub fn options(&self, base: &Options) -> Options {
        self.rung.applied_to(&Options { frame: self.frame, ..*base })
    }

    /// Scheme and number of subsamples; also the axes if they are not the default, and the updates if there are several.
    pub fn name(&self) -> String {
        let mut name = format!("{} {}", self.rung.scheme.word(), self.rung.subsamples);
        if self.rung.updates_per_sample > 1 {
            name += &format!(" × {}", self.rung.updates_per_sample);
        }
        if self.frame != Frame::default() {
            name += &format!(" {}", self.frame.word());
        }
        name
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_marked_ones_are_in_the_matrix() {
        let all = Configuration::all();
        let default = Configuration::of(&Options::default());
        assert!(all.contains(&default) && all.contains(&Configuration::PAPER));
        assert_eq!(
            (default.name(), Configuration::PAPER.name()),
            ("exact 2".into(), "paper 2 geographic".into())
        );
        assert!(default.is_default_family() && !Configuration::PAPER.is_default_family());
        assert_eq!(
            Configuration::of(&Configuration::PAPER.options(&Options::default())),
            Configuration::PAPER
        );
    }
}
