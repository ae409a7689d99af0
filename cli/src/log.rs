//! `sins log`: looks at a flight log, and makes a path of it that an INS can fly.

use std::path::{Path, PathBuf};

use sins::scene::Scene;
use sins::truth::smooth::{SmoothOptions, Smoothed, SmoothedPart};
use sins::units::DEG;

use crate::failure::Failure;
use crate::given::{Reading, judge, read_log_as};
use crate::output::Outputs;
use crate::terminal::{print, say};
use crate::units::{six_digits, time_text};

/// The first line of a smoothed log.
const MARK: &str = "# smoothed by sins log";

const COLUMNS: &str = "time_s,latitude_deg,longitude_deg,height_m,velocity_east_m_s,velocity_north_m_s,velocity_up_m_s,roll_deg,pitch_deg,heading_deg";

/// Most rows of a smoothed log.
const MOST_ROWS: f64 = 1e8;

/// Looks at a flight log, and smooths it
///
/// Prints what the log has and what the judge finds in it. With --smooth, noise, coarse steps, repeated rows, outliers and stamps that
/// scatter are smoothed: the path is that of splines whose cut-off follows from the spectrum of the rows. Its velocity is the derivative of its position.
/// The path is written as a log that `sins fly` flies.
#[derive(Debug, clap::Args)]
pub struct Order {
    /// Flight log ("-": standard input)
    file: PathBuf,
    /// Smooths the log
    #[arg(long, requires = "output")]
    smooth: bool,
    /// The smoothed log
    #[arg(short, long, value_name = "TRUTH.csv", requires = "smooth")]
    output: Option<PathBuf>,
    /// Also replaces a file that this program did not write
    #[arg(long)]
    force: bool,
    /// Rate of the smoothed log
    #[arg(long, value_name = "HZ", default_value_t = 50.0)]
    rate: f64,
    /// Assumes a coordinated flight without wind at this angle of attack: the attitude follows from the path, and the log needs none
    #[arg(long, value_name = "ATTACK_DEG", num_args = 0..=1, default_missing_value = "0")]
    coordinated: Option<f64>,
    /// White noise of a horizontal component of the position [default: found from the rows]
    #[arg(long, value_name = "METRES")]
    position_sigma: Option<f64>,
    /// White noise of an angle of the attitude [default: found from the rows]
    #[arg(long, value_name = "DEG")]
    attitude_sigma: Option<f64>,
}

pub fn run(order: &Order) -> Result<(), Failure> {
    let reading = if order.coordinated.is_some() { Reading::WithoutAttitude } else { Reading::Whole };
    let log = read_log_as(&order.file, reading)?;
    let scene = Scene::default();
    let findings = judge(&scene, &order.file, &log, log.samples().len());
    let Some(output) = &order.output else {
        let (rows, duration_s) = (log.samples().len(), log.duration_s());
        let rate_hz = six_digits((rows - 1) as f64 / duration_s);
        let has = |is: bool| if is { "with" } else { "without" };
        let velocities = has(log.samples()[0].v_n.is_some());
        print(&format!(
            "{}: {rows} rows over {}, {rate_hz} Hz, {velocities} velocities\n",
            order.file.display(),
            time_text(duration_s)
        ))?;
        let lines: String = findings.iter().map(|(_, words)| format!("{words}\n")).collect();
        return print(if lines.is_empty() { "nothing is doubtful\n" } else { &lines });
    };
    findings.iter().for_each(|(_, words)| say(words));
    let options = SmoothOptions {
        position_sigma_m: order.position_sigma,
        attitude_sigma_rad: order.attitude_sigma.map(|degrees| degrees * DEG),
        coordinated_attack_rad: order.coordinated.map(|degrees| degrees * DEG),
    };
    let place = |error: &sins::Error| match error.index {
        Some(index) => format!("{}:{}: {error}", order.file.display(), log.line(index).unwrap_or_default()),
        None => format!("{}: {error}", order.file.display()),
    };
    let smoothed = Smoothed::new(&scene.options.earth(), log.samples(), &options)
        .map_err(|error| Failure::new(place(&error)))?;
    write(order, output, &smoothed)?;
    said(&smoothed, log.samples()[0].v_n.is_some()).iter().for_each(|line| say(line));
    Ok(())
}

/// Writes the path as a log.
fn write(order: &Order, path: &Path, smoothed: &Smoothed) -> Result<(), Failure> {
    let [start_s, end_s] = smoothed.span_s();
    let rows = (end_s - start_s) * order.rate;
    if !(1.0..=MOST_ROWS).contains(&rows) {
        let what = format!("--rate {}: {rows} rows; must be from 1 to {MOST_ROWS:e}", order.rate);
        return Err(Failure::new(what));
    }
    let mut file = Outputs::new(std::slice::from_ref(&order.file), order.force).file(path, MARK)?;
    let mut line = |text: &str| {
        use std::io::Write;
        writeln!(file, "{text}").map_err(|error| Failure::of_output(path, &error))
    };
    line(MARK)?;
    line(COLUMNS)?;
    for k in 0..=rows.floor() as u64 {
        let time_s = (start_s + k as f64 / order.rate).min(end_s);
        let sample = smoothed.sample_at(time_s).map_err(|error| Failure::of_file(&order.file, &error))?;
        let (place, euler) = (sample.place, sample.euler);
        let [east, north, up] = sample.v_n.unwrap_or_default().into();
        line(&format!(
            "{time_s},{},{},{},{east},{north},{up},{},{},{}",
            place.latitude_rad / DEG,
            place.longitude_rad / DEG,
            place.height_m,
            euler.roll / DEG,
            euler.pitch / DEG,
            euler.heading / DEG
        ))?;
    }
    file.commit()
}

/// What was done, in lines.
fn said(smoothed: &Smoothed, had_velocities: bool) -> Vec<String> {
    let part = |name: &str, part: &SmoothedPart, unit: &str, si: f64| {
        format!(
            "{name}: motion above {} Hz is lost; noise {} {unit}; {} outliers; largest residual {} {unit} at {} s",
            six_digits((part.cutoff_hz * 1e3).round() / 1e3),
            digits(part.noise / si),
            part.outliers,
            digits(part.largest / si),
            six_digits(part.largest_at_s)
        )
    };
    let mut lines =
        vec![part("position", &smoothed.position(), "m", 1.0), part("height", &smoothed.height(), "m", 1.0)];
    if smoothed.is_coordinated {
        lines.push("attitude: assumed, that of a coordinated flight without wind".to_owned());
    } else {
        lines.push(part("attitude", &smoothed.attitude(), "deg", DEG));
    }
    if smoothed.left_out > 0 {
        lines.push(format!(
            "{} rows are left out: zeros at the start, repeats, or too near to the row before",
            smoothed.left_out
        ));
    }
    if smoothed.is_steady_clock {
        lines.push("the time stamps are replaced by those of a steady clock".to_owned());
    }
    if had_velocities {
        lines
            .push("the velocities of the log are not used: those of the path are its derivatives".to_owned());
    }
    lines
}

/// A number with two significant digits.
fn digits(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        size if size >= 100.0 => format!("{value:.0}"),
        size if size >= 1.0 => format!("{value:.1}"),
        size if size >= 1e-3 => format!("{value:.4}"),
        _ => format!("{value:.1e}"),
    }
}
