//! The configurations of the matrix: schemes, subsamples and axes.

use sins::Options;
use sins::mechanization::{Frame, Scheme};
use sins::recommend::Rung;

/// Subsamples of each scheme. More than two leave the paper's error as it is, or add 2 % to it.
const SCHEMES: [(Scheme, std::ops::RangeInclusive<usize>); 3] =
    [(Scheme::Paper, 1..=2), (Scheme::Exact, 1..=5), (Scheme::Polynomial, 1..=5)];

/// Of all rungs with 2 or 4 updates in a sample those that reached a Pareto front, each on one scene.
const SEVERAL_UPDATES: [Rung; 2] = [
    Rung { scheme: Scheme::Exact, subsamples: 2, updates_per_sample: 2 },
    Rung { scheme: Scheme::Polynomial, subsamples: 4, updates_per_sample: 2 },
];

/// How the mechanization is set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Configuration {
    pub rung: Rung,
    pub frame: Frame,
}

/// The word of a scheme, as scenes have it.
pub fn scheme_name(scheme: Scheme) -> &'static str {
    match scheme {
        Scheme::Paper => "paper",
        Scheme::Exact => "exact",
        Scheme::Polynomial => "polynomial",
    }
}

impl Configuration {
    /// The paper's own.
    pub const PAPER: Self = Self {
        rung: Rung { scheme: Scheme::Paper, subsamples: 2, updates_per_sample: 1 },
        frame: Frame::Geographic,
    };

    /// That of `options`.
    pub fn of(options: &Options) -> Self {
        let Options { scheme, subsamples, updates_per_sample, frame, .. } = *options;
        Self { rung: Rung { scheme, subsamples, updates_per_sample }, frame }
    }

    /// Those of the matrix, by frame, scheme and subsamples; those with several updates last.
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

    /// Whether it is one of the family that a user chooses from: what the library itself is made of, where no pole disturbs.
    pub fn is_default_family(&self) -> bool {
        self.frame == Frame::EarthFixed && self.rung.scheme != Scheme::Paper
    }

    /// `base` with this scheme and these axes.
    pub fn options(&self, base: &Options) -> Options {
        self.rung.applied_to(&Options { frame: self.frame, ..*base })
    }

    pub fn scheme_name(&self) -> &'static str {
        scheme_name(self.rung.scheme)
    }

    pub fn frame_name(&self) -> &'static str {
        match self.frame {
            Frame::EarthFixed => "Earth-fixed",
            Frame::Geographic => "geographic",
        }
    }

    /// Scheme and subsamples; the axes where they are not the default, the updates where there are several.
    pub fn name(&self) -> String {
        let mut name = format!("{} {}", self.scheme_name(), self.rung.subsamples);
        if self.rung.updates_per_sample > 1 {
            name += &format!(" × {}", self.rung.updates_per_sample);
        }
        if self.frame != Frame::default() {
            name += &format!(" {}", self.frame_name());
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
