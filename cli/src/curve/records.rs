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
    let mut rows = vec![POINTS.map(str::to_owned).to_vec()];
    for survey in surveys {
        rows.extend(survey.points.iter().map(|point| row(survey, point, instructions)));
    }
    text(&rows)
}

fn row(survey: &Survey, point: &Point, instructions: &Instructions) -> Vec<String> {
    let configuration = &point.configuration;
    let rung = &configuration.rung;
    let counted = instructions.of(configuration).map_or_else(String::new, |count| count.to_string());
    let mut row = vec![
        survey.name.clone(),
        configuration.scheme_name().to_owned(),
        rung.subsamples.to_string(),
        rung.updates_per_sample.to_string(),
        configuration.frame_name().to_owned(),
        point.rate_hz.to_string(),
    ];
    match &point.measured {
        Ok(measured) => {
            let judgement = &measured.judgement;
            let floors = ["position", "velocity", "attitude"].into_iter().zip(judgement.at_floor);
            let floors: Vec<&str> =
                floors.filter_map(|(name, is_at_floor)| is_at_floor.then_some(name)).collect();
            row.extend([format!("{:.0}", measured.cost_ns), counted]);
            let error = &judgement.error;
            row.extend(
                [error.position_m, error.velocity_m_s, error.attitude_rad].map(|e| format!("{e:.4e}")),
            );
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

/// A row for each scene: what its reference knows, and what sensors would err.
pub fn scenes(surveys: &[Survey]) -> Result<String, Failure> {
    let mut rows = vec![SCENES.map(str::to_owned).to_vec()];
    for survey in surveys {
        let uncertainty = &survey.uncertainty;
        let mut row = vec![
            survey.name.clone(),
            survey.title.clone(),
            survey.duration_s.to_string(),
            survey.reference.to_owned(),
        ];
        row.extend(
            [uncertainty.position_m, uncertainty.velocity_m_s, uncertainty.attitude_rad]
                .into_iter()
                .chain(survey.sensors_m)
                .map(|value| format!("{value:.3e}")),
        );
        rows.push(row);
    }
    text(&rows)
}
