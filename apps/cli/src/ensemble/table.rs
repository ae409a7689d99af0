//! Statistics over time and errors at the end as CSV files.

use std::io::Write;

use sins::ensemble::statistics::Figures;

use super::plan::{Data, Plan};
use super::requirement::along_cross;
use super::results::{Results, State};
use crate::failure::Failure;
use crate::given::Given;
use crate::rows::EAST_NORTH_UP;
use crate::rows::number;

/// The three errors and their units, as in the names of columns.
const QUANTITIES: [(&str, &str); 3] = [("position", "m"), ("velocity", "m_s"), ("misalignment", "rad")];

/// Beginnings of the file of statistics and of the file of the runs, by which the program recognizes its own files.
pub const MARK: &str = "time_s,error_data,runs,diverged,out_of_range,";
pub const RUNS_MARK: &str = "run,diverged,";

/// Figures of the runs at an instant, by one of the two error data.
#[derive(Debug, Clone)]
pub struct Row {
    pub time_s: f64,
    pub source: Data,
    pub figures: Figures,
    /// Direction of the truth's track [rad].
    pub track_rad: f64,
}

impl Row {
    /// Number of runs that the figures are of.
    pub fn good(&self) -> u64 {
        self.figures.runs - self.figures.diverged - self.figures.out_of_range
    }

    pub fn mean(&self) -> State {
        self.figures.mean.into()
    }

    pub fn sigma(&self) -> State {
        std::array::from_fn(|k| self.figures.covariance[(k, k)].sqrt())
    }

    pub fn rms(&self) -> State {
        self.figures.rms.into()
    }

    /// Mean position error along the track and to the right of it [m].
    pub fn track_mean(&self) -> [f64; 2] {
        along_cross(&self.mean(), self.track_rad)
    }

    /// Standard deviation of the position error along the track and across it [m].
    pub fn track_sigma(&self) -> [f64; 2] {
        let (sine, cosine) = self.track_rad.sin_cos();
        let [east, north, both] = [(0, 0), (1, 1), (0, 1)].map(|place| self.figures.covariance[place]);
        let variance = |e: f64, n: f64| (e * e * east + n * n * north + 2.0 * e * n * both).max(0.0);
        [variance(sine, cosine), variance(cosine, -sine)].map(f64::sqrt)
    }

    /// Covariance of the position east and north [m²].
    pub fn east_north(&self) -> f64 {
        self.figures.covariance[(0, 1)]
    }
}

/// The rows of `results` in the order of time. The rows of the sources of an instant follow one another.
pub fn rows(given: &Given, plan: &Plan, results: &Results) -> Result<Vec<Row>, Failure> {
    let mut rows = Vec::with_capacity(plan.count());
    let instants = plan.instants.iter().zip(&results.tracks);
    for ((index, track_rad), at) in instants.zip(results.statistics.chunks(plan.sources.len())) {
        let time_s = given.sample(*index)?.time_s;
        for (source, statistics) in plan.sources.iter().zip(at) {
            rows.push(Row { time_s, source: *source, figures: statistics.figures()?, track_rad: *track_rad });
        }
    }
    Ok(rows)
}

/// The file of statistics. Numbers have the format `%.9e` of C, so that a host in C writes the same bytes.
pub fn statistics(rows: &[Row]) -> String {
    let names = |what: &str| states(what).join(",");
    let mut text = format!(
        "{MARK}{},{},{},position_covariance_east_north_m2,cep50_m,r95_m,largest_m\n",
        names("mean_"),
        names("sigma_"),
        names("rms_")
    );
    for row in rows {
        let figures = &row.figures;
        let data = match row.source {
            Data::Navigation => 2,
            Data::Model => 1,
            Data::Shown => 3,
        };
        let counts = [figures.runs, figures.diverged, figures.out_of_range].map(|count| count.to_string());
        text += &format!("{:.6},{data},{}", row.time_s, counts.join(","));
        let radial = [figures.cep50_m, figures.r95_m, figures.largest_radial_m];
        // Of no run there are no figures, and of one run no scatter.
        let of = |values: &[f64], least: u64| -> String {
            let number = |value: &f64| {
                if row.good() < least { ",".to_owned() } else { format!(",{}", scientific(*value)) }
            };
            values.iter().map(number).collect()
        };
        text += &(of(&row.mean(), 1) + &of(&row.sigma(), 2) + &of(&row.rms(), 1));
        text += &(of(&[row.east_north()], 2) + &of(&radial, 1));
        text += "\n";
    }
    text
}

/// Writes the errors of each run at the end; a run that diverged has none.
pub fn write_runs(plan: &Plan, results: &Results, to: &mut impl Write) -> std::io::Result<()> {
    writeln!(to, "{RUNS_MARK}{},radial_m,position_along_m,position_cross_m", states("").join(","))?;
    let track_rad = results.tracks.last().copied().unwrap_or_default();
    for (run, end) in (plan.first_run..=u64::MAX).zip(&results.ends) {
        write!(to, "{run},{}", u8::from(end.is_none()))?;
        match end {
            Some(state) => {
                let more = [radial(state)].into_iter().chain(along_cross(state, track_rad));
                state.iter().copied().chain(more).try_for_each(|value| write!(to, ",{}", number(value)))?;
                writeln!(to)?;
            }
            None => writeln!(to, ",,,,,,,,,,,,")?,
        }
    }
    Ok(())
}

/// Horizontal position error [m].
pub fn radial(state: &State) -> f64 {
    state[0].hypot(state[1])
}

/// The names of the nine errors.
fn states(begin: &str) -> Vec<String> {
    let of = |(what, unit): (&str, &str)| EAST_NORTH_UP.map(|axis| format!("{begin}{what}_{axis}_{unit}"));
    QUANTITIES.into_iter().flat_map(of).collect()
}

/// Number in the format `%.9e` of C: the exponent has its sign and at least two digits.
fn scientific(value: f64) -> String {
    let text = format!("{value:.9e}");
    match text.split_once('e') {
        Some((digits, exponent)) => match exponent.strip_prefix('-') {
            Some(exponent) => format!("{digits}e-{exponent:0>2}"),
            None => format!("{digits}e+{exponent:0>2}"),
        },
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_c() {
        for (value, text) in [
            (0.0, "0.000000000e+00"),
            (-1234.5, "-1.234500000e+03"),
            (1.25e-7, "1.250000000e-07"),
            (9.999_999_999_9e-101, "1.000000000e-100"),
            (3e300, "3.000000000e+300"),
        ] {
            assert_eq!(scientific(value), text);
        }
    }
}
