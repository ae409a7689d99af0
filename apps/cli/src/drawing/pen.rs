//! Pens are named after the meaning of their lines and have no colours. Each pen is a CSS class of the drawings, so that the page's
//! style sheet chooses the colours for light, dark and print.

/// The pens, each with its class in the style sheet, and whether it draws dots.
macro_rules! pens {
    ($($(#[$doc:meta])* $pen:ident $class:literal $($dot:ident)?,)*) => {
        /// Meaning of a line; the style sheet defines its look.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Pen {
            $($(#[$doc])* $pen),*
        }

        impl Pen {
            #[cfg(test)]
            pub const ALL: &[Self] = &[$(Self::$pen),*];

            /// Class of the pen in the style sheet.
            pub fn class(self) -> &'static str {
                match self {
                    $(Self::$pen => $class),*
                }
            }

            /// Whether the pen draws dots, not lines.
            pub fn is_dot(self) -> bool {
                match self {
                    $(Self::$pen => !stringify!($($dot)?).is_empty()),*
                }
            }
        }
    };
}

pens! {
    Text "text", Axis "axis",
    /// Computed values: thin, dark, over `Reference`.
    Computed "computed",
    /// Values that `Computed` is compared with: broad, light.
    Reference "reference",
    East "east", North "north", Up "up",
    /// One standard deviation, above and below.
    Sigma "sigma",
    /// Single records of a noisy signal.
    Record "record",
    Fit "fit", NauticalMile "nautical-mile", Schuler "schuler", Foucault "foucault", Day "day", Start "start" dot,
    /// End of the truth.
    End "end" dot,
    /// Rows of a log.
    Row "row" dot,
    /// Begin and end of a failure of a sensor.
    Failure "failure",
    /// An update by a fix, and the end of an alignment.
    Correction "correction",
    /// Computed values at the end of a long track.
    Late "late",
    /// Points of a scheme, and the line that joins them.
    PaperScheme "paper-scheme" dot, ExactScheme "exact-scheme" dot, PolynomialScheme "polynomial-scheme" dot,
    /// Points of the three schemes with too few samples.
    PaperHollow "paper-hollow" dot, ExactHollow "exact-hollow" dot, PolynomialHollow "polynomial-hollow" dot,
    /// Text in a dot.
    Digit "digit",
    /// The Pareto front.
    Front "front",
    /// Rings around the points of one configuration, and the text at them.
    DefaultRing "default-ring" dot, PaperRing "paper-ring" dot,
    /// Position error that sensors of a grade cause.
    Navigation "navigation", Tactical "tactical",
    /// The smallest error that a reference shows.
    Floor "floor",
    /// An area where the truth may be.
    Band "band",
    /// A wider area around `Band`.
    OuterBand "outer-band",
    /// Deviation of one term alone.
    Asymptote "asymptote",
    /// Bars of a random effect, of a deterministic effect, of the mechanization, and of all effects together.
    Random "random", Deterministic "deterministic", Own "own", Together "together",
    /// Bars of effects that can be left out.
    PaleRandom "pale-random", PaleDeterministic "pale-deterministic",
    /// The value at a bar.
    Value "value",
    /// Limit within which effects may be left out.
    Limit "limit",
    /// End of one run of an ensemble, and number of runs in a bar of the histogram.
    Run "run" dot, Count "count",
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
