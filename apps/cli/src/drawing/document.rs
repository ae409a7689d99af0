//! HTML pages that need nothing from outside.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::figure::Figure;
use super::foot::foot;
use super::pen::Pen;
use super::policy::policy;
use super::script::script;

/// The style of drawings, which the script copies into files, and that of the page.
const STYLES: [&str; 2] = [include_str!("plot.css"), include_str!("page.css")];

/// What the script does. Without script it is hidden.
const HELP: &str = "Point at a curve, a dot or a bar for its values; drag to enlarge a part, double-click to go back. Keys: \
                    ← and → move the cursor, + and − enlarge and reduce, Esc goes back.";

/// Mark near the beginning of every page, by which the program recognizes its own pages.
pub const PAGE_MARK: &str = "<meta name=\"generator\" content=\"sins\">";

/// `body` as a page that needs nothing from outside.
pub fn document(title: &str, body: &Markup) -> String {
    let body = body.clone().into_string();
    let script = body.contains("<g class=\"panel\"").then(script);
    let markup = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                meta name="generator" content="sins";
                meta http-equiv="Content-Security-Policy" content=(policy(script.as_deref(), &STYLES));
                title { (title) }
                @for style in STYLES { style { (PreEscaped(style)) } }
            }
            body {
                (PreEscaped(&body))
                @if script.is_some() { p.help hidden { (HELP) } }
                (foot())
                @if let Some(script) = &script { script { (PreEscaped(script)) } }
            }
        }
    };
    markup.into_string()
}

pub fn figure(figure: &Figure) -> Markup {
    html! {
        figure {
            h3 { (figure.title) }
            ul.legend {
                @for (pen, text) in &figure.legend { li { (swatch(*pen)) span { (text) } } }
            }
            @for drawing in &figure.drawings { (PreEscaped(drawing)) }
            figcaption { (figure.note) }
        }
    }
}

/// A table: heads of its columns, if it has any; for each row, its name and its cells.
pub fn table(
    class: Option<&str>,
    heads: Vec<String>,
    rows: impl IntoIterator<Item = (Markup, Markup)>,
) -> Markup {
    html! {
        table class=[class] {
            @if !heads.is_empty() { thead { tr { @for head in heads { th scope="col" { (head) } } } } }
            tbody { @for (name, cells) in rows { tr { th scope="row" { (name) } (cells) } } }
        }
    }
}

/// Sample of the line or dot that `pen` draws.
pub fn swatch(pen: Pen) -> Markup {
    html! {
        svg.swatch aria-hidden="true" viewBox="0 0 340 140" {
            @if pen.is_dot() {
                circle class=(pen.class()) cx="170" cy="70" r="60" {}
            } @else {
                line class=(pen.class()) x1="0" y1="70" x2="340" y2="70" {}
            }
        }
    }
}
