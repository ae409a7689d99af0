//! The rows of a log beside the smooth path that was fitted to them.

use std::path::Path;

use crate::drawing::figure::Figure;
use crate::drawing::pen::Pen;
use crate::drawing::plot::{Dot, Trace};
use crate::drawing::scales::{line, over_time, panel, time_axis};
use crate::drawing::series::magnitude;
use crate::failure::Failure;
use crate::given::open_table;
use crate::places::beside;
use crate::report::figures::LOWER;
use crate::report::path::local;
use crate::report::run::{Places, Run};
use crate::rows::EAST_NORTH_UP;
use crate::rows::ROW_COLUMNS;
use crate::table::Table;
use crate::units::{LENGTH, fitting, with_unit};

/// Most rows that are drawn on a map, and radius of their dots [drawing units].
const MOST: usize = 400;
const RADIUS: f64 = 2.0;

/// The rows of a log.
pub struct Rows {
    /// Time since the first record [s].
    pub time_s: Vec<f64>,
    pub places: Places,
    /// Position less that of the path, east, north, up [m].
    pub residual_m: [Vec<f64>; 3],
}

impl Rows {
    /// Those beside the records at `path`, which begin at `start_s`; `None`: there are none.
    pub fn read(path: &Path, start_s: f64) -> Result<Option<Self>, Failure> {
        let path = beside(path, "_rows.csv");
        if !path.is_file() {
            return Ok(None);
        }
        let (input, _) = open_table(&path)?;
        let mut table = Table::read(&path, input)?;
        let columns = ROW_COLUMNS.iter().map(|name| table.take(name)).collect::<Result<Vec<_>, _>>()?;
        let Ok([time_s, latitude_rad, longitude_rad, height_m, east, north, up]) =
            <[Vec<f64>; 7]>::try_from(columns)
        else {
            return Ok(None);
        };
        let zeros = || vec![0.0; time_s.len()];
        let velocity_m_s = [zeros(), zeros(), zeros()];
        let places = Places { latitude_rad, longitude_rad, height_m, velocity_m_s };
        let time_s = time_s.iter().map(|time_s| time_s - start_s).collect();
        Ok(Some(Self { time_s, places, residual_m: [east, north, up] }))
    }

    /// Some of them on the map around the first place of `truth`, in units of `si` [m].
    pub fn dots(&self, truth: &Places, si: f64) -> Vec<Dot> {
        let (east, north) = local(&self.places, truth, 0.0);
        let dot = |row: usize| Dot {
            at: (east[row] / si, north[row] / si),
            pen: Pen::Row,
            radius: RADIUS,
            label: None,
        };
        (0..east.len()).step_by(east.len().div_ceil(MOST).max(1)).map(dot).collect()
    }
}

/// The residuals over time; `None`: the flight is no smoothed log.
pub fn figure(run: &Run) -> Result<Option<Figure>, Failure> {
    let Some(rows) = &run.rows else { return Ok(None) };
    let time = time_axis(run.duration_s());
    let largest = rows.residual_m.each_ref().map(|values| magnitude(values));
    let unit = fitting(largest.iter().copied().fold(0.0, f64::max), LENGTH);
    let axes = EAST_NORTH_UP.iter().zip(&rows.residual_m);
    let panels: Vec<_> = axes
        .map(|(axis, values)| {
            let trace = Trace::new(Pen::Record, line(&rows.time_s, values, &time, unit));
            panel(format!("{axis} [{}]", unit.name), 100.0, 5, vec![trace])
        })
        .collect();
    let drawing = over_time(time, panels).of_height(LOWER);
    let rms = rows.residual_m.each_ref().map(|values| {
        let squares: f64 = values.iter().map(|value| value * value).sum();
        with_unit((squares / values.len().max(1) as f64).sqrt(), LENGTH)
    });
    let note = format!(
        "{} rows; root mean square east {}, north {}, up {}. Outliers count, and have no weight in the path.",
        rows.time_s.len(),
        rms[0],
        rms[1],
        rms[2]
    );
    let legend = vec![(Pen::Record, "position of a row less that of the smooth path".to_owned())];
    Figure::new("Rows of the log", " over time", legend, &drawing, note).map(Some)
}
