//! Samples of a budget: a scene, or its first part, without its failures and updates.

use sins::truth::FlightSample;
use sins::{Error, ErrorParameters, Options};

use crate::given::Given;
use crate::units::time_text;

/// A scene.
pub struct BudgetScene {
    pub name: String,
    pub title: String,
    pub options: Options,
    pub parameters: ErrorParameters,
    pub count: usize,
    /// Time between two samples; for a log, the mean [s].
    pub period_s: f64,
    given: Given,
}

impl BudgetScene {
    /// The first `most_s` [s] of `given`, or all of `given` if it is shorter.
    pub fn new(given: Given, most_s: f64) -> Self {
        let count = given.index_at(most_s).max(1) + 1;
        let scene = &given.scene;
        let title = given.title.trim_end_matches('.');
        let span_s = given.time_s(count - 1);
        let without = match (scene.failures.is_empty(), scene.updates.is_empty()) {
            (true, true) => "",
            (false, true) => ", without its failures",
            (true, false) => ", without its updates",
            (false, false) => ", without its failures and updates",
        };
        let rate_hz = 1.0 / given.period_s;
        Self {
            name: given.name.clone(),
            title: format!(
                "{title}, {} at {} Hz{without}",
                time_text(span_s),
                (rate_hz * 10.0).round() / 10.0
            ),
            options: scene.simulator_options(),
            parameters: scene.errors,
            count,
            period_s: given.period_s,
            given,
        }
    }

    /// The sample `index`, with the scene's temperature.
    pub fn sample(&self, index: usize) -> Result<FlightSample, Error> {
        let mut sample = self.given.sample(index)?;
        if let Some(temperature) = &self.given.scene.temperature {
            sample.temperature_c = Some(temperature.at(sample.time_s - self.given.start_s));
        }
        Ok(sample)
    }

    /// What a reader must know before the figures, in sentences.
    pub fn warnings(&self) -> Vec<String> {
        self.given.warnings(self.given.left_out())
    }

    /// Place of a refused sample; without an index, the origin of the scene.
    pub fn place(&self, index: Option<usize>) -> String {
        index.map_or_else(|| self.given.origin.clone(), |index| self.given.place(index))
    }
}
