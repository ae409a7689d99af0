//! Attitude, velocity and position errors over time: error data 2 over error data 1.

use crate::drawing::figure::{Figure, Legend};
use crate::drawing::pen::Pen;
use crate::drawing::plot::{Drawing, Panel, Trace};
use crate::drawing::scales::{line, over_time, panel, time_axis};
use crate::drawing::series::{difference, magnitude};
use crate::failure::Failure;
use crate::report::run::{Errors, Run};
use crate::report::unit;
use crate::rows::EAST_NORTH_UP;
use crate::units::{self, Family, Unit, fitting, fitting_axis, in_unit, usual, with_unit};

/// Pens of the differences.
const PENS: [Pen; 3] = [Pen::East, Pen::North, Pen::Up];

/// One of the three errors.
pub struct Quantity {
    title: &'static str,
    /// Figure of the paper with this error.
    figure: u32,
    name: &'static str,
    family: &'static Family,
    of: fn(&Errors) -> &[Vec<f64>; 3],
    /// Whether its up axis is the vertical channel.
    is_motion: bool,
}

pub const ATTITUDE: Quantity = Quantity {
    title: "Attitude errors",
    figure: 3,
    name: "misalignment",
    family: units::ANGLE,
    of: |errors| &errors.misalignment_rad,
    is_motion: false,
};

pub const VELOCITY: Quantity = Quantity {
    title: "Velocity errors",
    figure: 4,
    name: "velocity",
    family: units::SPEED,
    of: |errors| &errors.velocity_m_s,
    is_motion: true,
};

pub const POSITION: Quantity = Quantity {
    title: "Position errors",
    figure: 5,
    name: "position",
    family: units::LENGTH,
    of: |errors| &errors.position_m,
    is_motion: true,
};

/// Figure of the error for the page.
pub fn figure(run: &Run, quantity: &Quantity) -> Result<Figure, Failure> {
    let axes = axes(run, quantity);
    let note = note(run, quantity, axes);
    let drawing = drawing(run, quantity).of_height(height(run));
    Figure::new(title(run, quantity), " over time", legend(run, quantity), &drawing, note)
}

/// Height of the figures of the three errors of `run` [drawing units]: that of the one with the most panels.
pub fn height(run: &Run) -> f64 {
    [&ATTITUDE, &VELOCITY, &POSITION]
        .map(|quantity| drawing(run, quantity).height())
        .into_iter()
        .fold(0.0, f64::max)
}

/// Title of the figure; a simulation of the paper has the number of the paper's figure.
pub fn title(run: &Run, quantity: &Quantity) -> String {
    let Quantity { title, figure, .. } = quantity;
    if run.is_of_paper() { format!("{title} (figure {figure} of the paper)") } else { (*title).to_owned() }
}

/// The name of navigation minus truth, and that of the solution of the error differential equations. The paper's own names stand before
/// them in its simulations.
fn names(run: &Run) -> [&'static str; 2] {
    if run.is_of_paper() {
        ["data 2: navigation minus truth", "data 1: error differential equations"]
    } else {
        ["navigation minus truth", "error differential equations"]
    }
}

/// A panel for each axis, and the difference of data 2 and data 1 below.
pub fn drawing(run: &Run, quantity: &Quantity) -> Drawing {
    let time = time_axis(run.duration_s());
    let (axes, computed) = (axes(run, quantity), (quantity.of)(&run.errors));
    let model = run.model.as_ref().map(quantity.of);
    let sigma = run.sigma.as_ref().map(quantity.of);
    let size_of = |three: Option<&[Vec<f64>; 3]>, axis: usize| three.map_or(0.0, |t| magnitude(&t[axis]));
    let size = |axis: usize| magnitude(&computed[axis]).max(size_of(model, axis)).max(size_of(sigma, axis));
    let largest = (0..axes).map(size).fold(0.0, f64::max);
    let mut panels: Vec<Panel> = (0..axes)
        .map(|axis| {
            let unit = fitting_axis(size(axis), largest, quantity.family);
            let trace = |pen, values: &[f64]| Trace::new(pen, line(&run.time_s, values, &time, unit));
            let mut traces: Vec<Trace> =
                model.iter().map(|model| trace(Pen::Reference, &model[axis])).collect();
            if let Some(sigma) = sigma {
                let below: Vec<f64> = sigma[axis].iter().map(|sigma| -sigma).collect();
                traces.extend([&sigma[axis], &below].map(|values| trace(Pen::Sigma, values)));
            }
            traces.push(trace(Pen::Computed, &computed[axis]));
            panel(caption(quantity.name, EAST_NORTH_UP[axis], unit), 110.0, 5, traces)
        })
        .collect();
    if let Some(differences) = differences(run, quantity) {
        let unit =
            fitting(differences[..axes].iter().map(|d| magnitude(d)).fold(0.0, f64::max), quantity.family);
        let traces = PENS
            .into_iter()
            .zip(&differences[..axes])
            .map(|(pen, values)| Trace::new(pen, line(&run.time_s, values, &time, unit)));
        panels.push(panel(format!("difference of the two [{}]", unit.name), 80.0, 4, traces.collect()));
    }
    run.events.mark(&time, &mut panels);
    panels.extend(unit::band(run, &time));
    over_time(time, panels)
}

/// Legend of the lines.
pub fn legend(run: &Run, quantity: &Quantity) -> Legend {
    let [computed, model] = names(run).map(str::to_owned);
    let mut legend = vec![(Pen::Computed, computed)];
    if run.model.is_some() {
        legend.push((Pen::Reference, model));
    }
    if run.sigma.is_some() {
        legend.push((Pen::Sigma, "±1σ of all runs, by the covariance".to_owned()));
    }
    if differences(run, quantity).is_some() {
        let names = PENS.into_iter().zip(EAST_NORTH_UP).take(axes(run, quantity));
        legend.extend(names.map(|(pen, name)| (pen, format!("difference, {name}"))));
    }
    legend.extend(run.events.legend(&time_axis(run.duration_s())));
    legend
}

/// Number of axes that are drawn, east first: without up if the height follows the truth.
fn axes(run: &Run, quantity: &Quantity) -> usize {
    if quantity.is_motion && run.follows_height() { 2 } else { 3 }
}

fn caption(what: &str, which: &str, unit: Unit) -> String {
    format!("{what} {which} [{}]", unit.name)
}

/// Error data 2 less error data 1; `None` without the model, or if data 1 is zero.
fn differences(run: &Run, quantity: &Quantity) -> Option<[Vec<f64>; 3]> {
    let (computed, model) = ((quantity.of)(&run.errors), (quantity.of)(run.model.as_ref()?));
    if model.iter().all(|values| magnitude(values) == 0.0) {
        return None;
    }
    Some(std::array::from_fn(|axis| difference(&computed[axis], &model[axis])))
}

/// The largest errors and differences as text.
fn note(run: &Run, quantity: &Quantity, axes: usize) -> String {
    let as_text = |three: &[Vec<f64>; 3]| {
        let sizes: Vec<f64> = three[..axes].iter().map(|values| magnitude(values)).collect();
        let largest = sizes.iter().copied().fold(0.0, f64::max);
        let text = |size: f64| match usual(largest, quantity.family) {
            unit if size >= 1e-3 * largest => in_unit(size, unit),
            _ => with_unit(size, quantity.family),
        };
        let parts: Vec<String> =
            EAST_NORTH_UP.iter().zip(sizes).map(|(name, size)| format!("{name} {}", text(size))).collect();
        parts.join(", ")
    };
    let mut note = format!("Largest: {}.", as_text((quantity.of)(&run.errors)));
    let differences = differences(run, quantity);
    if let Some(differences) = &differences {
        note += &format!(" Largest difference of the two: {}.", as_text(differences));
    }
    if run.model.is_some() && differences.is_none() {
        note += " The error differential equations have no error to solve.";
    }
    if axes < 3 {
        note += " Up is not shown: the vertical channel follows the truth.";
    }
    note
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::run::tests::{made, with_sigmas};
    use crate::report::summary::Row;

    #[test]
    fn up_is_left_out_where_the_height_is_the_truths() {
        let mut run = made(3, |name, _| match name {
            "navigation_error_position_up_m" => 1e-9,
            _ if name.starts_with("model_error") && !name.ends_with("flags") => 1.0,
            _ => 0.0,
        });
        assert_eq!(drawing(&run, &POSITION).panels.len(), 4);
        assert!(note(&run, &POSITION, 3).contains("up 1.000×10⁻⁹ m"));

        run.summary.rows.push(Row::made("vertical", "follow", ""));
        let panels = |quantity| drawing(&run, quantity).panels.len();
        assert_eq!((panels(&ATTITUDE), panels(&VELOCITY), panels(&POSITION)), (4, 3, 3));
        let figure = figure(&run, &POSITION).unwrap();
        assert!(figure.note.ends_with("the vertical channel follows the truth."), "{}", figure.note);
        assert!(!figure.legend.iter().any(|(pen, _)| *pen == Pen::Up));
    }

    #[test]
    fn an_envelope_is_drawn_where_there_is_a_covariance() {
        let run = with_sigmas(3, |name, _| if name.starts_with("sigma_position") { 7.0 } else { 0.5 });
        let panel = &drawing(&run, &POSITION).panels[0];
        let envelope: Vec<&Trace> = panel.traces.iter().filter(|trace| trace.pen == Pen::Sigma).collect();
        assert_eq!((envelope[0].points[0].1, envelope[1].points[0].1), (7.0, -7.0));
        assert!(panel.y.low <= -7.0 && panel.y.high >= 7.0);
        assert!(legend(&run, &POSITION).iter().any(|(pen, _)| *pen == Pen::Sigma));
        let without = made(3, |_, _| 0.5);
        assert!(!legend(&without, &POSITION).iter().any(|(pen, _)| *pen == Pen::Sigma));
    }

    #[test]
    fn what_is_compared_with_zero_has_no_difference() {
        let run = made(3, |name, _| if name.starts_with("navigation_error_velocity") { 0.5 } else { 0.0 });
        assert_eq!(drawing(&run, &VELOCITY).panels.len(), 3);
        let figure = figure(&run, &VELOCITY).unwrap();
        assert_eq!(figure.legend.len(), 2);
        assert!(figure.note.ends_with("no error to solve."), "{}", figure.note);
    }
}
