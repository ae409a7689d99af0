//! `sins live`: flies the INS of a scene on the packets of a flight simulator, and sends back what the INS believes.
//!
//! The data flow is `link` → `packet` (`native`, `text`, `json`, `foreign`) → `gate` (`ticks`) → `leg` → `answer` (`native`, `json`,
//! `nmea`) → `link`; `blank` and `log` have the files, `traffic` counts, `voice` speaks, `run` connects. What the gate passes does not
//! depend on any clock of this machine.

mod answer;
mod blank;
mod delays;
mod foreign;
mod gate;
mod json;
mod leg;
mod link;
mod log;
mod native;
mod nmea;
mod packet;
mod run;
mod text;
mod ticks;
mod traffic;
mod voice;

use std::ffi::OsString;

use sins::truth::Intake;
use sins::unit::bus::Inputs;

use crate::failure::Failure;
use crate::fly::FOR_LOGS;
use crate::given::{Given, Settings};
use crate::interrupt;
use crate::output::Outputs;
use crate::places::OutputArguments;
use answer::{Answers, Send};
use blank::Names;
use gate::{Gate, Jump, Pause};
use link::{Source, Target};
use packet::Format;
use run::Live;
use ticks::Ticks;
use voice::Voice;

/// Flies the INS of a scene live on the packets of a flight simulator (FlightGear, JSBSim, X-Plane): docs/live.md
///
/// Writes the files of `sins fly` for each flight, and draws them on DIR/NAME.html. Ctrl-C ends it.
///
/// Without a scene, the sensors are ideal.
#[derive(Debug, clap::Args)]
pub struct Order {
    /// A built-in scene (`sins scene list`), or a file SCENE.toml; its own flight is left out
    #[arg(value_name = "SCENE")]
    scene: Option<OsString>,
    /// Where packets come to: udp:PORT from this machine, udp:0.0.0.0:PORT from others too; port 0: any that is free
    #[arg(long, value_name = "udp:PORT")]
    from: String,
    /// Format of the packets
    #[arg(long, value_enum, default_value_t = Format::Fgfs)]
    format: Format,
    /// Stated rate of the packets [default: the scene's options.sample_period_s]. The format fgfs needs it, because it has no time
    #[arg(long, value_name = "HZ")]
    rate_hz: Option<f64>,
    /// Where answers go
    #[arg(long, value_name = "udp:HOST:PORT")]
    to: Option<String>,
    /// What the answers are
    #[arg(long, value_enum, requires = "to", default_value_t = Send::Json)]
    send: Send,
    /// What is done while the aircraft stands still in flight
    #[arg(long, value_enum, default_value_t = Pause::Cut)]
    pause: Pause,
    /// What is done when the aircraft was moved, after a gap beyond the scene's options.max_gap_s, or when the clock went back
    #[arg(long, value_enum, default_value_t = Jump::Restart)]
    jump: Jump,
    /// Also records the samples in this log in DIR, and beside it a scene that flies the log to the same bits
    #[arg(long, value_name = "FILE.csv")]
    record: Option<String>,
    /// Ends after this time of flight [s]
    #[arg(long, value_name = "S")]
    seconds: Option<f64>,
    /// Ends when no packet came, or every one was refused, for this time [s], once one was flown. A pause does not count
    #[arg(long, value_name = "S")]
    silence_s: Option<f64>,
    #[command(flatten)]
    settings: Settings,
    #[command(flatten)]
    output: OutputArguments,
}

pub fn run(order: &Order) -> Result<(), Failure> {
    for (option, value) in
        [("--rate-hz", order.rate_hz), ("--seconds", order.seconds), ("--silence-s", order.silence_s)]
    {
        if let Some(value) = value
            && !(value > 0.0 && value.is_finite())
        {
            return Err(Failure::new(format!("{option} {value}: must be above 0")));
        }
    }
    let mut given = Given::live(order.scene.as_deref(), &order.settings, FOR_LOGS)?;
    if let Some(rate_hz) = order.rate_hz {
        given.scene.options.intake.period_s = Some(1.0 / rate_hz);
    }
    if order.to.is_some() && matches!(order.send, Send::Bus | Send::Words) && given.scene.unit()?.is_none() {
        let what = "--send bus: the scene has no unit, which sends the words; --set unit.start=nav adds one";
        return Err(Failure::new(what));
    }
    // An invalid option of the scene is reported before the first packet.
    given.scene.simulator()?;
    let (folder, name) = order.output.places(&given)?;
    let names = Names::new(folder, name, order.record.as_deref())?;
    let target = order.to.as_deref().map(Target::open).transpose()?;
    let inputs = Inputs { axes: given.scene.options.axes, ..Inputs::default() };
    let live = Live {
        gate: gate(order, &given)?,
        answers: target.map(|target| (target, Answers::new(order.send, inputs))),
        source: Source::open(&order.from)?,
        format: order.format,
        seconds: order.seconds.unwrap_or(f64::INFINITY),
        silence_s: order.silence_s.unwrap_or(f64::INFINITY),
        voice: Voice::new(order.output.is_quiet(&given)),
        outputs: Outputs::new(&given.inputs, order.output.force),
        given: &given,
        names,
    };
    interrupt::graceful();
    live.run()
}

/// The gate of the packets, with the limits of the scene's simulator.
fn gate(order: &Order, given: &Given) -> Result<Gate, Failure> {
    let options = given.scene.simulator_options();
    let ticks = match options.intake.period_s {
        _ if order.format.has_time() => None,
        Some(period_s) => Some(Ticks::new(options.earth(), period_s)),
        None => {
            let what = "--format fgfs: the packets have no time; state their rate, for example --rate-hz 60";
            return Err(Failure::new(what));
        }
    };
    let intake = Intake::new(options.earth(), options.axes, options.intake)?;
    Ok(Gate::new(intake, options.intake.max_gap_s, ticks, order.pause, order.jump))
}
