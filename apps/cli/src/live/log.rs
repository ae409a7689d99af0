//! The log of a flight, and a scene that flies it again to the same bits.

use std::io::Write;
use std::path::Path;

use sins::records;
use sins::scene::FlightSource;
use sins::truth::FlightSample;

use crate::failure::Failure;
use crate::given::Given;
use crate::output::{OutputFile, Outputs};

/// The first line of a log.
const LOG_MARK: &str = "# live flight";

/// The columns of a log.
const COLUMNS: &str = "time_s,latitude_rad,longitude_rad,height_m,velocity_east_m_s,velocity_north_m_s,velocity_up_m_s,\
    roll_rad,pitch_rad,heading_rad";

/// The first line of a scene that flies a log again.
const SCENE_MARK: &str = "# flies the log of a live flight again, to the same bits";

/// A log and the scene that flies it. Both have their names from the first interval on, so that nothing ends a session without them.
pub struct Log {
    file: OutputFile,
    /// `None` when it is in place.
    scene: Option<OutputFile>,
}

impl Log {
    /// The log at `path`, and the scene beside it; `None`: there is a file of one of their names.
    pub fn open(outputs: &mut Outputs, path: &Path) -> Result<Option<Self>, Failure> {
        let Some(file) = outputs.new_file(path, LOG_MARK)? else { return Ok(None) };
        let scene = outputs.new_file(&path.with_extension("toml"), SCENE_MARK)?;
        Ok(scene.map(|scene| Self { file, scene: Some(scene) }))
    }

    /// Writes the first sample.
    pub fn begin(&mut self, first: &FlightSample) -> Result<(), Failure> {
        self.line(LOG_MARK)?;
        self.line(COLUMNS)?;
        self.sample(first)
    }

    pub fn sample(&mut self, sample: &FlightSample) -> Result<(), Failure> {
        let FlightSample { time_s, place, v_n, euler, .. } = sample;
        let v_n = v_n.unwrap_or_default();
        let place = [*time_s, place.latitude_rad, place.longitude_rad, place.height_m];
        let motion = [v_n.x, v_n.y, v_n.z, euler.roll, euler.pitch, euler.heading];
        self.line(&records::line(place.into_iter().chain(motion)))
    }

    /// Puts both in place, once: the log, and the scene of the flight with this log and the spacing of its records.
    pub fn publish(&mut self, given: &Given, every_s: f64) -> Result<(), Failure> {
        let Some(file) = self.scene.take() else { return Ok(()) };
        self.file.publish()?;
        let name = |part: Option<&std::ffi::OsStr>| part.unwrap_or_default().to_string_lossy().into_owned();
        let mut scene = given.scene.clone();
        scene.flight = FlightSource::Log(name(self.file.path().file_name()));
        scene.output.every_s = Some(every_s);
        scene.output.name = format!("{}_replay", name(self.file.path().file_stem()));
        file.finish(format!("{SCENE_MARK}\n\n{}", scene.write()))
    }

    /// Writes what is in the buffer, and reports an error of the disk.
    pub fn check(&mut self) -> Result<(), Failure> {
        self.file.check()
    }

    /// Ends the log behind the last line that the disk has taken.
    pub fn commit(self) -> Result<(), Failure> {
        self.file.commit_lines()
    }

    fn line(&mut self, line: &str) -> Result<(), Failure> {
        writeln!(self.file, "{line}").map_err(|error| Failure::of_output(self.file.path(), &error))
    }
}
