//! An instance of the unit: its phase, its values, its simulator.

use std::path::PathBuf;
use std::sync::Arc;

use sins::Error;
use sins::scene::{Play, Scene, Source};
use sins::truth::{FlightSample, Pushed};

use crate::corrections;
use crate::inputs;
use crate::outputs;
use crate::panel;
use crate::scene;
use crate::table::{Table, table};
use crate::values::{Base, Value, Values};
use crate::variable::Role;

/// Phase in the life of an instance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    Instantiated,
    Initializing,
    Stepping,
    Terminated,
}

/// Status of a refused call. The call does not change the instance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refusal {
    /// A refused value; with another one, the simulation can continue.
    Discard,
    /// A call that is not allowed here, or a refused sample.
    Error,
}

/// A refused call: its status and the reason.
#[derive(Debug)]
pub struct Refused {
    pub refusal: Refusal,
    pub text: String,
}

impl Refused {
    pub fn error(text: impl Into<String>) -> Self {
        Self { refusal: Refusal::Error, text: text.into() }
    }

    pub fn discard(text: impl Into<String>) -> Self {
        Self { refusal: Refusal::Discard, text: text.into() }
    }
}

/// What a step flew.
#[derive(Debug, Clone, Default)]
pub struct Flown {
    /// Whether the step closed a gap in the truth.
    pub behind_gap: bool,
    /// Angle by which the vehicle turned in its interval [rad].
    pub turn_rad: f64,
    /// Entries at the panel that the box refused.
    pub refused_entries: Vec<String>,
    /// What suggests inputs that are not connected.
    pub unconnected: Vec<&'static str>,
    /// The sample that was taken; `None`: the step takes none.
    pub sample: Option<FlightSample>,
}

/// The last sample that was taken.
#[derive(Debug, Clone)]
pub struct Taken {
    /// Time stamp [s].
    pub time_s: f64,
    /// Inputs of the truth.
    pub inputs: Vec<f64>,
    /// Number of corrections that the master had counted.
    pub corrections: i32,
    /// Numbers of entries at the panel and of fixes that it had counted.
    pub entries: panel::Counts,
}

/// The scene of the parameters in flight, with its simulator and its box, and the last sample.
#[derive(Debug, Clone)]
pub struct Flight {
    pub play: Play,
    pub taken: Option<Taken>,
}

impl Flight {
    /// The flight that the parameters define, before its first sample.
    pub fn new(values: &Values, resources: Option<&PathBuf>) -> Result<Self, String> {
        let scene = scene::scene(values, resources.map(PathBuf::as_path))?;
        let play = Play::new(Arc::new(scene), Source::Host).map_err(|error| error.to_string())?;
        Ok(Self { play, taken: None })
    }

    /// Replaces the sensor errors and failures by those of `scene`.
    fn retune(&mut self, scene: &Scene) -> Result<(), Error> {
        let mut play = self.play.clone();
        let before = self.play.itinerary().scene();
        let simulator = play.simulator_mut();
        if scene.errors.gyro != before.errors.gyro {
            simulator.set_gyro(&scene.errors.gyro)?;
        }
        if scene.errors.accel != before.errors.accel {
            simulator.set_accel(&scene.errors.accel)?;
        }
        if scene.errors.altimeter != before.errors.altimeter {
            simulator.set_altimeter(&scene.errors.altimeter)?;
        }
        play.set_plan(scene)?;
        self.play = play;
        Ok(())
    }

    /// The flight after the corrections, what is done at the panel, and the interval that ends at `time_s` [s].
    fn flown(&self, time_s: f64, values: &Values, is_set: &[bool; inputs::COUNT]) -> Result<Next, String> {
        let sample = inputs::sample(time_s, values, is_set)?;
        let unconnected = self
            .taken
            .as_ref()
            .map_or(Vec::new(), |taken| inputs::unconnected(&sample, &taken.inputs, time_s - taken.time_s));
        let mut play = self.play.clone();
        if self.taken.as_ref().is_some_and(|taken| taken.corrections != corrections::count(values)) {
            play.simulator_mut().correct(&corrections::correction(values)).map_err(sentence)?;
        }
        // After the first sample there is no interval yet.
        let refused_entries = match (&self.taken, play.unit_mut()) {
            (None, _) => Vec::new(),
            (Some(taken), None) => panel::without_a_box(values, taken.entries),
            (Some(taken), Some((unit, _))) => panel::act(values, taken.entries, unit)?,
        };
        let pushed = play.push(&sample).map_err(|stopped| sentence(stopped.error))?;
        if let (Some(taken), Some((unit, simulator))) = (&self.taken, play.unit_mut()) {
            panel::push_fix(values, taken.entries, unit, simulator).map_err(sentence)?;
        }
        Ok(Next { play, behind_gap: pushed == Pushed::BehindGap, refused_entries, unconnected, sample })
    }
}

/// The sentence of an error, with the name of the variable, if it is about one. Indices are those of FMI, from 1.
fn sentence(error: Error) -> String {
    if let Some(field) = inputs::name_of(&error) {
        return Error { field, index: None, ..error }.to_string();
    }
    match corrections::name_of(&error) {
        Some(name) => error.sentence_about(&name),
        None => Error { index: error.index.map(|index| index + 1), ..error }.to_string(),
    }
}

/// What a step leads to.
struct Next {
    play: Play,
    behind_gap: bool,
    refused_entries: Vec<String>,
    unconnected: Vec<&'static str>,
    sample: FlightSample,
}

/// An instance.
#[derive(Debug, Clone)]
pub struct Instance {
    pub table: Arc<Table>,
    /// The unit's folder of resources.
    pub resources: Option<PathBuf>,
    pub phase: Phase,
    pub values: Values,
    /// Whether the master has set each input of the truth.
    pub is_set: [bool; inputs::COUNT],
    pub flight: Option<Flight>,
    /// End of the last step [s].
    pub end_s: f64,
}

impl Instance {
    pub fn new(resources: Option<PathBuf>) -> Self {
        let table = table();
        Self {
            resources,
            phase: Phase::Instantiated,
            values: table.start.clone(),
            table,
            is_set: [false; inputs::COUNT],
            flight: None,
            end_s: 0.0,
        }
    }

    /// Restores the state after instantiation.
    pub fn reset(&mut self) {
        *self = Self::new(self.resources.take());
    }

    /// Changes the phase from `from` to `to`.
    pub fn go(&mut self, from: Phase, to: Phase) -> Result<(), Refused> {
        self.require(&[from])?;
        if to == Phase::Stepping {
            self.flight = Some(Flight::new(&self.values, self.resources.as_ref()).map_err(Refused::error)?);
        }
        self.phase = to;
        Ok(())
    }

    /// Refuses a call if the phase is none of `phases`.
    pub fn require(&self, phases: &[Phase]) -> Result<(), Refused> {
        match phases.contains(&self.phase) {
            true => Ok(()),
            false => Err(Refused::error(format!("has no place in the phase {:?}", self.phase))),
        }
    }

    /// Sets variables by their references: all or none.
    pub fn set(&mut self, values: impl Iterator<Item = (usize, Value)>) -> Result<(), Refused> {
        let mut next = self.values.clone();
        let mut is_set = self.is_set;
        let mut is_tuned = false;
        for (place, value) in values {
            let base = value.base();
            let variable = self
                .table
                .variable(base, place)
                .ok_or_else(|| Refused::error(format!("there is no {base:?} of reference {place}")))?;
            let phases: &[Phase] = match variable.role {
                Role::Output => &[],
                Role::Fixed => &[Phase::Instantiated, Phase::Initializing],
                Role::Input | Role::Tunable => &[Phase::Instantiated, Phase::Initializing, Phase::Stepping],
            };
            self.require(phases).map_err(|refused| {
                Refused::error(format!("{} cannot be set: {}", variable.name, refused.text))
            })?;
            match variable.role {
                Role::Input => {
                    let of_truth = is_set.get_mut(place).filter(|_| base == Base::Real);
                    of_truth.into_iter().for_each(|is_set| *is_set = true);
                }
                _ => is_tuned |= next.get(base, place).as_ref() != Some(&value),
            }
            let _ = next.set(place, value);
        }
        if is_tuned && let Some(flight) = &mut self.flight {
            let resources = self.resources.as_deref();
            let scene = scene::scene(&next, resources).map_err(Refused::discard)?;
            flight.retune(&scene).map_err(|error| Refused::discard(error.to_string()))?;
        }
        (self.values, self.is_set) = (next, is_set);
        Ok(())
    }

    /// The value of a variable.
    pub fn get(&self, base: Base, place: usize) -> Result<Value, Refused> {
        let unknown = || Refused::error(format!("there is no {base:?} of reference {place}"));
        self.values.get(base, place).ok_or_else(unknown)
    }

    /// Flies a step from `time_s` over `length_s` [s]. The interval that it flies has ended: a shorter step changes nothing, so
    /// every refusal is an error. Masters repeat a discarded step.
    pub fn step(&mut self, time_s: f64, length_s: f64) -> Result<Flown, Refused> {
        self.require(&[Phase::Stepping])?;
        if !(length_s.is_finite() && length_s >= 0.0) {
            return Err(Refused::error(format!(
                "communicationStepSize = {length_s}: must be a finite number, not negative"
            )));
        }
        let Some(flight) = &mut self.flight else { return Err(Refused::error("there is no flight")) };
        let inputs = &self.values.reals[..inputs::COUNT];
        match &flight.taken {
            Some(taken) if taken.time_s == time_s => {
                if taken.inputs != inputs {
                    let text =
                        format!("the inputs at {time_s} s have changed, and their sample has been taken");
                    return Err(Refused::error(text));
                }
                self.end_s = time_s + length_s;
                return Ok(Flown::default());
            }
            _ => {}
        }
        let Next { mut play, behind_gap, refused_entries, unconnected, sample } =
            flight.flown(time_s, &self.values, &self.is_set).map_err(Refused::error)?;
        let turn_rad = flight.taken.as_ref().map_or(0.0, |before| inputs::turn_rad(&before.inputs, inputs));
        let taken = Taken {
            time_s,
            inputs: inputs.to_vec(),
            corrections: corrections::count(&self.values),
            entries: panel::counts(&self.values),
        };
        outputs::read(&mut play, behind_gap, &mut self.values)
            .map_err(|error| Refused::error(error.to_string()))?;
        (flight.play, flight.taken) = (play, Some(taken));
        self.end_s = time_s + length_s;
        Ok(Flown { behind_gap, turn_rad, refused_entries, unconnected, sample: Some(sample) })
    }
}
