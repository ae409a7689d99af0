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
    /// An area where the truth may be.
    Band,
    /// What one term alone would make.
    Asymptote,
}

impl Pen {
    pub const ALL: [Self; 18] = [
        Self::Text,
        Self::Grid,
        Self::Axis,
        Self::Computed,
        Self::Reference,
        Self::East,
        Self::North,
        Self::Up,
        Self::Record,
        Self::Fit,
        Self::NauticalMile,
        Self::Schuler,
        Self::Foucault,
        Self::Day,
        Self::Start,
        Self::Late,
        Self::Band,
        Self::Asymptote,
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
            Self::Record => "record",
            Self::Fit => "fit",
            Self::NauticalMile => "nautical-mile",
            Self::Schuler => "schuler",
            Self::Foucault => "foucault",
            Self::Day => "day",
            Self::Start => "start",
            Self::Late => "late",
            Self::Band => "band",
            Self::Asymptote => "asymptote",
        }
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
