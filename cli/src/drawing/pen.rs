//! Pens are named by what their lines mean, not coloured: each is a CSS class of the drawings, so that the page's style
//! sheet chooses colours for light, dark and print.

use plotters::style::RGBColor;

/// The pens, each with its class in the style sheet, and whether it draws dots.
macro_rules! pens {
    ($($(#[$doc:meta])* $pen:ident $class:literal $($dot:ident)?,)*) => {
        /// What a line means; the style sheet says how it looks.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Pen {
            $($(#[$doc])* $pen),*
        }

        impl Pen {
            pub const ALL: &[Self] = &[$(Self::$pen),*];

            /// Its class in the style sheet.
            pub fn class(self) -> &'static str {
                match self {
                    $(Self::$pen => $class),*
                }
            }

            /// Whether it draws dots, not lines.
            pub fn is_dot(self) -> bool {
                match self {
                    $(Self::$pen => !stringify!($($dot)?).is_empty()),*
                }
            }
        }
    };
}

pens! {
    Text "text", Grid "grid", Axis "axis",
    /// What was computed: thin, dark, over `Reference`.
    Computed "computed",
    /// What it is compared with: broad, light.
    Reference "reference",
    East "east", North "north", Up "up",
    /// One standard deviation, above and below.
    Sigma "sigma",
    /// Single records of a noisy signal.
    Record "record",
    Fit "fit", NauticalMile "nautical-mile", Schuler "schuler", Foucault "foucault", Day "day", Start "start" dot,
    /// What was computed at the end of a long track.
    Late "late",
    /// Points of a scheme, and the line that joins them.
    PaperScheme "paper-scheme" dot, ExactScheme "exact-scheme" dot, PolynomialScheme "polynomial-scheme" dot,
    /// The three schemes where samples are too few.
    PaperHollow "paper-hollow" dot, ExactHollow "exact-hollow" dot, PolynomialHollow "polynomial-hollow" dot,
    /// In a dot.
    Digit "digit",
    /// The Pareto front.
    Front "front",
    /// Rings around the points of one configuration, and the text at them.
    DefaultRing "default-ring" dot, PaperRing "paper-ring" dot,
    /// What sensors of a grade err.
    Navigation "navigation", Tactical "tactical",
    /// The smallest error that a reference shows.
    Floor "floor",
    /// An area where the truth may be.
    Band "band",
    /// A wider one around it.
    OuterBand "outer-band",
    /// What one term alone would make.
    Asymptote "asymptote",
    /// Bars: of a random effect, of a deterministic one, of the mechanization, of all together.
    Random "random", Deterministic "deterministic", Own "own", Together "together",
    /// What may be left out.
    Limit "limit",
    /// Where one run of an ensemble ends, and how many of them end so.
    Run "run" dot, Count "count",
}

impl Pen {
    /// Its number, from 1, as a colour, for `plotters`.
    pub fn colour(self) -> RGBColor {
        RGBColor(0, 0, self as u8 + 1)
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
