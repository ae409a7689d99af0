//! The surveys as CSV.

use super::front::beaten_by;
use super::instructions::Instructions;
use super::survey::{Point, Survey};
use crate::failure::Failure;
use crate::rows::text;

/// Columns of the points.
pub const POINTS: [&str; 15] = [
    "scene",
    "scheme",
    "subsamples",
    "updates_per_sample",
    "frame",
    "rate_hz",
    "cost_ns_per_s",
    "instructions_per_step",
    "position_m",
    "velocity_m_s",
    "attitude_rad",
    "at_floor",
    "status",
    "on_front",
    "beaten_by",
];

/// A row for each configuration and rate.
pub fn points(surveys: &[Survey], instructions: &Instructions) -> Result<String, Failure> {
    let rows = surveys
        .iter()
        .flat_map(|survey| survey.points.iter().map(move |point| row(survey, point, instructions)));
    text(&POINTS, rows)
}

fn row(survey: &Survey, point: &Point, instructions: &Instructions) -> Vec<String> {
    let configuration = &point.configuration;
    let rung = &configuration.rung;
    let counted = instructions.of(configuration).map_or_else(String::new, |count| count.to_string());
    let mut row = vec![
        survey.name.clone(),
        rung.scheme.word().to_owned(),
        rung.subsamples.to_string(),
        rung.updates_per_sample.to_string(),
        configuration.frame.word().to_owned(),
        point.rate_hz.to_string(),
    ];
    match &point.measured {
        Ok(measured) => {
            let judgement = &measured.judgement;
            let floors = ["position", "velocity", "attitude"].into_iter().zip(judgement.at_floor);
            let floors: Vec<&str> =
                floors.filter_map(|(name, is_at_floor)| is_at_floor.then_some(name)).collect();
            row.extend([format!("{:.0}", measured.cost_ns), counted]);
            row.extend(judgement.error.parts().map(|part| format!("{part:.4e}")));
            row.push(floors.join(" "));
            row.push(if point.is_undersampled { "undersampled" } else { "" }.to_owned());
        }
        Err(reason) => {
            row.extend([String::new(), counted]);
            row.extend([const { String::new() }; 4]);
            row.push(reason.clone());
        }
    }
    row.push(u8::from(point.is_on_front).to_string());
    let beaten = beaten_by(&survey.points, point, survey.floor.position_m);
    row.push(beaten.map_or_else(String::new, |(other, _)| other.configuration.name()));
    row
}

/// Columns of the scenes.
pub const SCENES: [&str; 9] = [
    "scene",
    "title",
    "duration_s",
    "reference",
    "reference_position_m",
    "reference_velocity_m_s",
    "reference_attitude_rad",
    "navigation_grade_m",
    "tactical_grade_m",
];

/// A row for each scene: uncertainty of its reference, and errors that sensors would cause.
pub fn scenes(surveys: &[Survey]) -> Result<String, Failure> {
    let row = |survey: &Survey| {
        let mut row = vec![
            survey.name.clone(),
            survey.title.clone(),
            survey.duration_s.to_string(),
            survey.reference.to_owned(),
        ];
        let numbers = survey.uncertainty.parts().into_iter().chain(survey.sensors_m);
        row.extend(numbers.map(|value| format!("{value:.3e}")));
        row
    };
    text(&SCENES, surveys.iter().map(row))
}
