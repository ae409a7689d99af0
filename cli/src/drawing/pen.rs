//! Pens are named by what their lines mean, not coloured: each is a CSS class of the drawings, so that the page's style
//! sheet chooses colours for light, dark and print.

use plotters::style::RGBColor;

/// What a line means; the style sheet says how it looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pen {
    Text = 1,
    Grid,
    Axis,
    /// What was computed: thin, dark, over `Reference`.
    Computed,
    /// What it is compared with: broad, light.
    Reference,
    East,
    North,
    Up,
    /// One standard deviation, above and below.
    Sigma,
    /// Single records of a noisy signal.
    Record,
    Fit,
    NauticalMile,
    Schuler,
    Foucault,
    Day,
    Start,
    /// What was computed at the end of a long track.
    Late,
    /// Points of a scheme, and the line that joins them.
    PaperScheme,
    ExactScheme,
    PolynomialScheme,
    /// The three schemes where samples are too few.
    PaperHollow,
    ExactHollow,
    PolynomialHollow,
    /// In a dot.
    Digit,
    /// The Pareto front.
    Front,
    /// Rings around the points of one configuration, and the text at them.
    DefaultRing,
    PaperRing,
    /// What sensors of a grade err.
    Navigation,
    Tactical,
    /// The smallest error that a reference shows.
    Floor,
    /// An area where the truth may be.
    Band,
    /// A wider one around it.
    OuterBand,
    /// What one term alone would make.
    Asymptote,
    /// Bars: of a random effect, of a deterministic one, of the mechanization, of all together.
    Random,
    Deterministic,
    Own,
    Together,
    /// What may be left out.
    Limit,
    /// Where one run of an ensemble ends, and how many of them end so.
    Run,
    Count,
}

impl Pen {
    pub const ALL: [Self; 40] = [
        Self::Text,
        Self::Grid,
        Self::Axis,
        Self::Computed,
        Self::Reference,
        Self::East,
        Self::North,
        Self::Up,
        Self::Sigma,
        Self::Record,
        Self::Fit,
        Self::NauticalMile,
        Self::Schuler,
        Self::Foucault,
        Self::Day,
        Self::Start,
        Self::Late,
        Self::PaperScheme,
        Self::ExactScheme,
        Self::PolynomialScheme,
        Self::PaperHollow,
        Self::ExactHollow,
        Self::PolynomialHollow,
        Self::Digit,
        Self::Front,
        Self::DefaultRing,
        Self::PaperRing,
        Self::Navigation,
        Self::Tactical,
        Self::Floor,
        Self::Band,
        Self::OuterBand,
        Self::Asymptote,
        Self::Random,
        Self::Deterministic,
        Self::Own,
        Self::Together,
        Self::Limit,
        Self::Run,
        Self::Count,
    ];

    /// Its class in the style sheet.
    pub fn class(self) -> &'static str {
        match self {
            Self::Text => "text",
            Self::Grid => "grid",
            Self::Axis => "axis",
            Self::Computed => "computed",
            Self::Reference => "reference",
            Self::East => "east",
            Self::North => "north",
            Self::Up => "up",
            Self::Sigma => "sigma",
            Self::Record => "record",
            Self::Fit => "fit",
            Self::NauticalMile => "nautical-mile",
            Self::Schuler => "schuler",
            Self::Foucault => "foucault",
            Self::Day => "day",
            Self::Start => "start",
            Self::Late => "late",
            Self::PaperScheme => "paper-scheme",
            Self::ExactScheme => "exact-scheme",
            Self::PolynomialScheme => "polynomial-scheme",
            Self::PaperHollow => "paper-hollow",
            Self::ExactHollow => "exact-hollow",
            Self::PolynomialHollow => "polynomial-hollow",
            Self::Digit => "digit",
            Self::Front => "front",
            Self::DefaultRing => "default-ring",
            Self::PaperRing => "paper-ring",
            Self::Navigation => "navigation",
            Self::Tactical => "tactical",
            Self::Floor => "floor",
            Self::Band => "band",
            Self::OuterBand => "outer-band",
            Self::Asymptote => "asymptote",
            Self::Random => "random",
            Self::Deterministic => "deterministic",
            Self::Own => "own",
            Self::Together => "together",
            Self::Limit => "limit",
            Self::Run => "run",
            Self::Count => "count",
        }
    }

    /// Whether it draws dots, not lines.
    pub fn is_dot(self) -> bool {
        use Pen::*;
        matches!(
            self,
            Start
                | PaperScheme
                | ExactScheme
                | PolynomialScheme
                | PaperHollow
                | ExactHollow
                | PolynomialHollow
                | DefaultRing
                | PaperRing
                | Run
        )
    }

    /// Its number as a colour, for `plotters`.
    pub fn colour(self) -> RGBColor {
        RGBColor(0, 0, self as u8)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pen_has_a_rule_in_the_style_sheet() {
        let css = include_str!("plot.css");
        for pen in Pen::ALL {
            assert!(
                css.contains(&format!(".{} ", pen.class())) || css.contains(&format!(".{},", pen.class()))
            );
        }
    }
}
