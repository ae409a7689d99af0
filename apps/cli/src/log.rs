//! `sins log`: looks at a flight log, and makes a path of it that an INS can fly.

use std::path::{Path, PathBuf};

use sins::judge::Level;
use sins::log::{FlightLog, Question, nearest_names, survey};
use sins::scene::Scene;
use sins::units::DEG;

use crate::failure::{Failure, Kind};
use crate::given::{Json, ReadLog, Settings, Verdict, find_gaps, is_record, of_log, parse_log, read_bytes};
use crate::output::{NO_MARK, Outputs};
use crate::siblings;
use crate::terminal::{print, quoted, say};
use crate::units::{six_digits, time_text};
use crate::written;

/// The first line of a smoothed log.
const MARK: &str = "# smoothed by sins log";

/// The first line of a file with the columns of a table.
const MAP_MARK: &str = "# columns that sins log found";

const COLUMNS: &str = "time_s,latitude_deg,longitude_deg,height_m,velocity_east_m_s,velocity_north_m_s,velocity_up_m_s,roll_deg,pitch_deg,heading_deg";

/// Looks at a flight log, and smooths it
///
/// Prints what the log has and what the judge finds in it; of an unusable log the exit code is 2, as of its flight. With --smooth, noise,
/// coarse steps, repeated rows, outliers and stamps that scatter are smoothed: the path is that of splines whose cut-off follows from the
/// spectrum of the rows. Its velocity is the derivative of its position. The path is written as a log that `sins fly` flies.
#[derive(Debug, clap::Args)]
pub struct Order {
    /// Flight log: a table, or a flight record in IGC, GPX or FDR ("-": standard input)
    file: PathBuf,
    /// Reads the log by the [log] of this file, which names the columns of each quantity
    #[arg(long, value_name = "FILE.toml")]
    columns: Option<PathBuf>,
    /// Looks for the columns of a table of any kind, and writes them into this file for --columns
    ///
    /// Tables of many avionics, simulators and services are known by their columns (docs/your_log.md names them). Of another table,
    /// quantities, units and times are guessed from names, lines of units and values. What is not sure is said. What is unknown is asked,
    /// with exit code 2.
    #[arg(long, value_name = "MAP.toml", conflicts_with_all = ["columns", "smooth"])]
    map: Option<PathBuf>,
    /// Exits with code 1 if a finding is doubtful, as the commands that fly a log do with this option
    #[arg(long, conflicts_with = "smooth")]
    strict: bool,
    #[command(flatten)]
    json: Json,
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
    let bytes = read_bytes(&order.file)?;
    if let Some(map) = &order.map {
        if is_record(&bytes) {
            return Err(Failure::of_file(&order.file, &"is a flight record, which flies without --map"));
        }
        write_map(order, &bytes, map)?;
    }
    let columns = order.columns.as_ref().or(order.map.as_ref()).cloned();
    let settings = Settings { columns, ..Settings::default() };
    let mut mapping = settings.mapping()?.unwrap_or_default();
    if order.smooth {
        mapping.smooth = true;
        mapping.smooth_rate_hz = order.rate;
        mapping.position_sigma_m = order.position_sigma;
        mapping.attitude_sigma_rad = order.attitude_sigma.map(|degrees| degrees * DEG);
    }
    if let Some(degrees) = order.coordinated {
        (mapping.is_coordinated, mapping.attack_rad) = (true, degrees * DEG);
    }
    let scene = Scene { log: mapping, ..Scene::default() };
    let ReadLog { log: rows, others } = parse_log(&order.file, &bytes, &scene.log)?;
    // What flies is judged.
    let (log, failure) = match rows.clone().smoothed(&scene.options.earth()) {
        Ok(path) => (path, None),
        Err(error) => (rows.clone(), Some(of_log(&order.file, error))),
    };
    let count = log.samples().len();
    let mut verdict = Verdict::new(&scene, &order.file, &log, count);
    if failure.is_none()
        && let Err((index, error)) = find_gaps(&scene, &log, count)
    {
        verdict.refuse(&scene, &log, index, &error);
    }
    let json = order.json.is_wanted;
    if json {
        print(&verdict.json())?;
    }
    match &order.output {
        Some(output) => {
            verdict.lines().filter(|_| !json).for_each(|line| say(&line));
            let inputs: Vec<PathBuf> = [order.file.clone()].into_iter().chain(others).collect();
            failure.map_or_else(|| write(order, &inputs, output, &log), Err)?;
            let next = format!("`sins fly {}`", quoted(output));
            if json { Ok(()) } else { print(&written::text(&[output], Some(&next))) }
        }
        None if json => failure.map_or_else(|| refuse(order, &verdict), Err),
        None => {
            print_rows(order, &rows)?;
            print(&verdict.lines().map(|line| line + "\n").collect::<String>())?;
            failure.map_or_else(|| conclude(order, &verdict), Err)
        }
    }
}

/// Prints what the rows are.
fn print_rows(order: &Order, log: &FlightLog) -> Result<(), Failure> {
    let (rows, duration_s) = (log.samples().len(), log.duration_s());
    let rate_hz = six_digits((rows - 1) as f64 / duration_s);
    let has = |is: bool| if is { "with" } else { "without" };
    let velocities = has(log.samples()[0].v_n.is_some());
    let (file, time) = (order.file.display(), time_text(duration_s));
    print(&format!("{file}: {rows} rows over {time}, {rate_hz} Hz, {velocities} velocities\n"))
}

/// Says what the findings mean, and what comes next.
fn conclude(order: &Order, verdict: &Verdict) -> Result<(), Failure> {
    let worst = verdict.worst();
    if worst < Some(Level::Doubtful) {
        print("nothing is doubtful\n")?;
    }
    if let Some(map) = &order.map {
        let (file, columns) = (quoted(&order.file), quoted(map));
        let next = match worst {
            Some(Level::Unusable) => {
                let again = format!("`sins log {file} --columns {columns}`");
                let smooth = format!("`sins log {file} --columns {columns} --smooth -o TRUTH.csv`");
                match verdict.advises_smoothing() {
                    true => format!(
                        "smooth it: {smooth}; or, if a column is wrong, mend {} and look again: {again}",
                        map.display()
                    ),
                    false => format!("mend {}, and look again: {again}", map.display()),
                }
            }
            _ => format!("`sins fly {file} --columns {columns}`"),
        };
        print(&written::text(&[map], Some(&next)))?;
    }
    refuse(order, verdict)
}

/// Refuses a log as a flight does.
fn refuse(order: &Order, verdict: &Verdict) -> Result<(), Failure> {
    let (kind, why) = match verdict.worst() {
        Some(Level::Unusable) => (Kind::Input, "a flight of this log is refused"),
        Some(Level::Doubtful) if order.strict => (Kind::Doubtful, "the log is refused (--strict)"),
        _ => return Ok(()),
    };
    Err(Failure::of_kind(kind, format!("{}: {why}", order.file.display())))
}

/// Looks for the columns of a table, and writes them.
fn write_map(order: &Order, table: &[u8], path: &Path) -> Result<(), Failure> {
    let file = order.file.display();
    let Some(mut found) = survey(table) else {
        let what = "no line at its beginning has known names of time, latitude and longitude: write a [log] with the names of the columns, as latitude = \"Y\", or, where no line has names, header = 0 and their numbers, as latitude = { col = 2 }";
        let names = nearest_names(table).map_or(String::new(), |names| format!("; {names}"));
        return Err(Failure::of_file(&order.file, &format!("{what}{names}")));
    };
    siblings::add(&order.file, &mut found);
    let format = found
        .format
        .map_or("guessed from names and values".to_owned(), |name| format!("of the format {name}"));
    let doubts: String = found.doubts.iter().map(|doubt| format!("# not sure: {doubt}\n")).collect();
    let questions: String = found.questions.iter().map(|question| asked(question, "# ")).collect();
    let text = format!("{MAP_MARK} in {file}, {format}\n{doubts}\n[log]\n{}{questions}", found.text);
    // One that was edited is not replaced.
    let is_same = std::fs::read(path).is_ok_and(|found| found == text.as_bytes());
    let mark = if is_same { MAP_MARK } else { NO_MARK };
    Outputs::new(std::slice::from_ref(&order.file), order.force).file(path, mark)?.finish(text)?;
    let doubts: String = found.doubts.iter().map(|doubt| format!("not sure: {doubt}\n")).collect();
    if found.questions.is_empty() {
        let text = format!("{}: the columns are {format}\n{doubts}", path.display());
        if order.json.is_wanted {
            say(text.trim_end());
            return Ok(());
        }
        return print(&text);
    }
    let questions: String = found.questions.iter().map(|question| asked(question, "")).collect();
    let [map, log] = [quoted(path), quoted(&order.file)];
    let next =
        format!("write an answer to each into {map}, and look again: `sins log {log} --columns {map}`");
    Err(Failure::of_file(&order.file, &format!("what flies is not certain\n{doubts}{questions}{next}")))
}

/// A question with its answers, which are lines of `[log]`.
fn asked(question: &Question, mark: &str) -> String {
    let answers = question.answers.iter().flat_map(|answer| answer.lines());
    let answers: String = answers.map(|line| format!("{mark}  {line}\n")).collect();
    format!("{mark}{}:\n{answers}", question.sentence)
}

/// Writes the path as a log.
fn write(order: &Order, inputs: &[PathBuf], path: &Path, smoothed: &FlightLog) -> Result<(), Failure> {
    let mut file = Outputs::new(inputs, order.force).file(path, MARK)?;
    let mut line = |text: &str| {
        use std::io::Write;
        writeln!(file, "{text}").map_err(|error| Failure::of_output(path, &error))
    };
    line(MARK)?;
    line(COLUMNS)?;
    for sample in smoothed.samples() {
        let (place, euler) = (sample.place, sample.euler);
        let [east, north, up] = sample.v_n.unwrap_or_default().into();
        line(&format!(
            "{},{},{},{},{east},{north},{up},{},{},{}",
            sample.time_s,
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
