//! Work-precision diagram of a scene: cost over accuracy. Accuracy increases to the right. Right of the line of the sensor errors,
//! more accuracy is of no use.

use maud::{PreEscaped, html};
use sins::Options;
use sins::mechanization::{Frame, Scheme};

use super::beside::{Circle, shifts};
use super::configuration::Configuration;
use super::front::front;
use super::survey::{Measured, Point, Survey};
use super::table::{rounded, short};
use crate::drawing::axis::{Axis, Scale};
use crate::drawing::figure::Legend;
use crate::drawing::file::{LEGEND, MARGIN, TITLE, file, legend_row, placed};
use crate::drawing::pen::Pen;
use crate::drawing::plot::{Dot, Drawing, FINE, LEFT, Label, Mark, Note, Panel, RIGHT, Trace};
use crate::drawing::series::{Points, positive_range};
use crate::failure::Failure;
use crate::units::{six_digits, time_text, two_digits};

/// Size of the drawing and of its axes [drawing units].
const WIDTH: f64 = 860.0;
const HEIGHT: f64 = 420.0;

/// Factor from nanoseconds to the unit of the axis.
const MICRO: f64 = 1e-3;

/// Radii of dots in Earth-fixed and in geographic axes, with several updates, and of the rings [drawing units].
const RADIUS: f64 = 6.0;
const SMALL: f64 = 2.6;
const WIDE: f64 = 10.0;
const RING: f64 = 8.5;

/// Shifts of the texts of the rates from the rings of the default and of the paper's configuration [drawing units].
const BELOW: (f64, f64) = (16.0, 9.0);
const ABOVE: (f64, f64) = (-16.0, -9.0);

/// Distance of the lines of navigation and of tactical grade from which both have their words above them [drawing units].
const WORDS: f64 = 75.0;

/// Height of a line of text below the drawing [drawing units].
const LINE: f64 = 20.0;

pub const HOW_TO_READ: [&str; 2] = [
    "Accuracy increases to the right. Right of the line of the sensors' own error, more accuracy is of no use.",
    "Numbers in dots: subsamples, × updates in a sample. At rings: samples a second. A dot beside another one has a line to its place.",
];

/// SVG file of the diagram.
pub fn diagram(survey: &Survey) -> Result<String, Failure> {
    let title = format!("{}: {}, {}", survey.name, survey.title, time_text(survey.duration_s));
    let drawing = drawing(survey, WIDTH);
    let svg = drawing.svg(&format!("What accuracy costs. {title}"))?;
    let [first, second] = legends(survey);
    let top = TITLE + 2.0 * LEGEND - 14.0;
    let below = top + drawing.height() + 10.0;
    let content = html! {
        text class="title" x=(MARGIN * FINE) y=(20.0 * FINE) { (title) }
        (legend_row(&first, TITLE - 6.0))
        (legend_row(&second, TITLE + LEGEND - 14.0))
        (placed(MARGIN, top, WIDTH, drawing.height(), &PreEscaped(svg)))
        @for (line, text) in (0..).zip(HOW_TO_READ) {
            text x=(MARGIN * FINE) y=((below + f64::from(line) * LINE) * FINE) { (text) }
        }
    };
    Ok(file(WIDTH + 2.0 * MARGIN, below + HOW_TO_READ.len() as f64 * LINE, &content))
}

/// The legend, in two rows.
pub fn legends(survey: &Survey) -> [Legend; 2] {
    let entry = |pen, text: &str| (pen, text.to_owned());
    let first = vec![
        entry(Pen::PaperScheme, "paper"),
        entry(Pen::ExactScheme, "exact"),
        entry(Pen::PolynomialScheme, "polynomial; small: geographic axes"),
        entry(Pen::DefaultRing, "default"),
        entry(Pen::PaperRing, "the paper's"),
    ];
    let [navigation, tactical] = survey.sensors_m.map(rounded);
    let mut second = vec![
        entry(Pen::Front, "Pareto front"),
        (Pen::Navigation, format!("navigation-grade sensors {navigation}")),
        (Pen::Tactical, format!("tactical-grade {tactical}")),
    ];
    if survey.points.iter().any(|point| point.is_undersampled) {
        second.push(entry(Pen::ExactHollow, "too few samples"));
    }
    [first, second]
}

/// The drawing, `width` wide [drawing units].
pub fn drawing(survey: &Survey, width: f64) -> Drawing {
    let measured: Vec<(&Point, &Measured)> =
        survey.points.iter().filter_map(|point| Some((point, point.measured.as_ref().ok()?))).collect();
    let (low, high) = positive_range(measured.iter().map(|(_, measured)| measured.cost_ns * MICRO));
    let cost = Axis::decades(low.log10() - 0.15, high.log10() + 0.2, 8);
    let errors = measured.iter().map(|(_, measured)| measured.position_m());
    let errors = errors.chain(survey.sensors_m).chain([survey.floor.position_m]);
    let x = accuracy(positive_range(errors));
    let mut panel = Panel::new("time for a simulated second [µs]", cost, HEIGHT, traces(survey));
    let room = width - LEFT - RIGHT;
    panel.marks = marks(survey, &x, room);
    let places = places(&measured, (&x, room), &panel.y);
    for ((point, measured), at) in measured.iter().zip(places) {
        let (from, pen) = (place(measured), pen(point.configuration, true));
        if at != from {
            panel.traces.push(Trace::new(pen, vec![from, at]));
        }
        panel.dots.push(dot(point, measured, at));
        panel.notes.extend(digit(point, at));
        if let Some((pen, shift)) = ring(point) {
            panel.dots.push(Dot { at, pen, radius: RING, label: None });
            panel.notes.push(Note { at, shift, pen, text: short(point.rate_hz) });
        }
    }
    let x_label = "largest position error on the way [m]";
    Drawing { width, left: LEFT, x, x_label: x_label.to_owned(), panels: vec![panel] }
}

/// Axis of powers of ten that decrease to the right; positions are negative logarithms.
fn accuracy((low, high): (f64, f64)) -> Axis {
    let rising = Axis::decades(low.log10() - 0.4, high.log10() + 0.4, 20);
    let ticks = rising.ticks.into_iter().rev().map(|(at, text)| (-at, text)).collect();
    Axis { low: -rising.high, high: -rising.low, ticks, scale: Scale::NegativeLogarithm }
}

fn place(measured: &Measured) -> (f64, f64) {
    (-measured.position_m().log10(), (measured.cost_ns * MICRO).log10())
}

/// Where the dots are drawn on axes of which that to the right is `room` long [drawing units]: dots that overlap beside each other.
fn places(measured: &[(&Point, &Measured)], (x, room): (&Axis, f64), y: &Axis) -> Vec<(f64, f64)> {
    let [unit_x, unit_y] = [room / (x.high - x.low), HEIGHT / (y.high - y.low)];
    let circle = |(point, measured): &(&Point, &Measured)| {
        let at = place(measured);
        let radius = if ring(point).is_some() { RING } else { radius(point) };
        ((at.0 - x.low) * unit_x, (y.high - at.1) * unit_y, radius)
    };
    let circles: Vec<Circle> = measured.iter().map(circle).collect();
    let shifted = measured.iter().zip(shifts(&circles, room)).map(|((_, measured), shift)| {
        let (right, up) = place(measured);
        (right + shift / unit_x, up)
    });
    shifted.collect()
}

/// The ring around the dots of the default and of the paper's configuration, and the shift of the text of its rate.
fn ring(point: &Point) -> Option<(Pen, (f64, f64))> {
    match point.configuration {
        which if which == Configuration::of(&Options::default()) => Some((Pen::DefaultRing, BELOW)),
        Configuration::PAPER => Some((Pen::PaperRing, ABOVE)),
        _ => None,
    }
}

fn radius(point: &Point) -> f64 {
    match point.configuration.rung.updates_per_sample {
        _ if point.configuration.frame == Frame::Geographic => SMALL,
        1 => RADIUS,
        _ => WIDE,
    }
}

/// Lines that join the rates of each configuration in Earth-fixed axes, and the front, drawn over the lines.
fn traces(survey: &Survey) -> Vec<Trace> {
    let earth_fixed = Configuration::all().into_iter().filter(|which| which.frame == Frame::EarthFixed);
    let mut traces: Vec<Trace> = earth_fixed
        .map(|which| {
            let own = survey.points.iter().filter(|point| point.configuration == which);
            Trace::new(pen(which, true), own.filter_map(Point::eligible).map(place).collect())
        })
        .collect();
    traces.push(Trace::new(Pen::Front, steps(front(&survey.points).into_iter().map(|(_, at)| place(at)))));
    traces
}

/// The front as stairs: more accuracy than a point has costs as much as the next point.
fn steps(front: impl Iterator<Item = (f64, f64)>) -> Points {
    let mut steps: Points = Vec::new();
    for (x, y) in front {
        if let Some(&(before, _)) = steps.last() {
            steps.push((before, y));
        }
        steps.push((x, y));
    }
    steps
}

/// Lines of the errors of sensors and of the floor, on an axis that is `width` long [drawing units].
fn marks(survey: &Survey, x: &Axis, width: f64) -> Vec<Mark> {
    let [navigation, tactical] = survey.sensors_m;
    let apart = width * (navigation / tactical).log10().abs() / (x.high - x.low);
    [
        (navigation, Pen::Navigation, "navigation"),
        (tactical, Pen::Tactical, if apart < WORDS { "" } else { "tactical" }),
        (survey.floor.position_m, Pen::Floor, "floor"),
    ]
    .into_iter()
    .filter(|(position_m, ..)| *position_m > 0.0)
    .map(|(position_m, pen, text)| Mark { at: -position_m.log10(), pen, text: text.to_owned() })
    .collect()
}

fn pen(configuration: Configuration, is_filled: bool) -> Pen {
    match (configuration.rung.scheme, is_filled) {
        (Scheme::Paper, true) => Pen::PaperScheme,
        (Scheme::Exact, true) => Pen::ExactScheme,
        (Scheme::Polynomial, true) => Pen::PolynomialScheme,
        (Scheme::Paper, false) => Pen::PaperHollow,
        (Scheme::Exact, false) => Pen::ExactHollow,
        (Scheme::Polynomial, false) => Pen::PolynomialHollow,
    }
}

fn dot(point: &Point, measured: &Measured, at: (f64, f64)) -> Dot {
    let (position_m, cost_us) = (measured.position_m(), measured.cost_ns * MICRO);
    let text = format!(
        "{} @ {} Hz: {}, {} µs a second{}",
        point.configuration.name(),
        short(point.rate_hz),
        rounded(position_m),
        two_digits(cost_us),
        if point.is_undersampled { ", too few samples" } else { "" }
    );
    let values = [position_m, cost_us].map(|value| six_digits(value).to_string());
    let pen = pen(point.configuration, !point.is_undersampled);
    Dot { at, pen, radius: radius(point), label: Some(Label { text, values }) }
}

/// Number of subsamples as a text in the dot, if the dot has room.
fn digit(point: &Point, at: (f64, f64)) -> Option<Note> {
    let has_room = point.configuration.frame == Frame::EarthFixed && !point.is_undersampled;
    let rung = &point.configuration.rung;
    let text = match rung.updates_per_sample {
        1 => rung.subsamples.to_string(),
        updates => format!("{}×{updates}", rung.subsamples),
    };
    has_room.then_some(Note { at, shift: (0.0, 0.0), pen: Pen::Digit, text })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::front::{self, tests::made};

    #[test]
    fn the_front_is_stairs_and_accuracy_grows_to_the_right() {
        let stairs = steps([(1.0, 1.0), (3.0, 2.0), (4.0, 5.0)].into_iter());
        assert_eq!(stairs, [(1.0, 1.0), (1.0, 2.0), (3.0, 2.0), (3.0, 5.0), (4.0, 5.0)]);
        let axis = accuracy((1e-3, 10.0));
        let texts: Vec<&str> = axis.ticks.iter().map(|(_, text)| text.as_str()).collect();
        assert_eq!(texts, ["10", "1", "0.1", "0.01", "0.001"]);
        assert!(axis.ticks.windows(2).all(|pair| pair[0].0 < pair[1].0) && axis.low < axis.high);
    }

    /// Points of nearly the same cost and accuracy: each can be seen, and points at.
    #[test]
    fn dots_that_overlap_are_drawn_beside_each_other() {
        let mut points: Vec<Point> =
            (0..6).map(|which| made(which, 5e3 * 1.01f64.powi(which as i32), 20.0)).collect();
        points.push(made(3, 8e5, 2e-4));
        let drawing = drawing(&Survey::made("a", 3600.0, points, [1e3, 1e5]), WIDTH);
        let (panel, x) = (&drawing.panels[0], &drawing.x);
        let [unit_x, unit_y] =
            [(WIDTH - LEFT - RIGHT) / (x.high - x.low), HEIGHT / (panel.y.high - panel.y.low)];
        let dots: Vec<&Dot> = panel.dots.iter().filter(|dot| dot.label.is_some()).collect();
        assert_eq!(dots.len(), 7);
        for (k, a) in dots.iter().enumerate() {
            for b in &dots[..k] {
                let apart = ((a.at.0 - b.at.0) * unit_x).hypot((a.at.1 - b.at.1) * unit_y);
                assert!(apart >= 0.999 * (a.radius + b.radius), "{apart}");
            }
        }
        // The lone one stands where it is.
        assert_eq!(dots[6].at, (-(2e-4f64).log10(), 800f64.log10()));
    }

    #[test]
    fn the_diagram_stands_alone() {
        let mut points = vec![made(0, 5e3, 20.0), made(3, 8e3, 0.4), made(13, 9e3, 2e-4)];
        points.push(Point { measured: Err("singular".into()), ..points[0].clone() });
        front::mark(&mut points);
        let svg = diagram(&Survey::made("a<b", 3600.0, points, [1e3, 1e5])).unwrap();
        assert!(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\"") && svg.ends_with("</svg>\n"));
        assert_eq!(svg.matches("http").count(), 1, "nothing from outside");
        assert!(svg.contains("a&lt;b") && !svg.contains("a<b"));
        for class in ["front", "default-ring", "paper-ring", "navigation", "tactical", "floor"] {
            assert!(svg.contains(&format!("class=\"{class}\"")), "{class}");
        }
    }
}
