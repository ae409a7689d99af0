//! Judges the truth that the master gives, for its warnings.

use sins::judge::Judge;
use sins::scene::Scene;
use sins::truth::FlightSample;

/// Samples between two looks at the findings.
const EVERY: u64 = 50;

/// A judge of the samples that steps take. A master that goes back in time repeats samples: those are judged once.
#[derive(Debug, Default)]
pub struct Watch {
    /// The judge, and the time stamp of its last sample [s].
    judge: Option<(Box<Judge>, f64)>,
}

impl Watch {
    /// Judges a sample of the flight of `scene`. The doubts that are new, in sentences.
    pub fn push(&mut self, scene: &Scene, sample: &FlightSample) -> Vec<String> {
        let judge = self.judge.get_or_insert_with(|| {
            let options = scene.simulator_options();
            let judge = Judge::new(options.earth(), options.intake.max_acceleration_m_s2)
                .expect("memory for a judge");
            (Box::new(judge), f64::NEG_INFINITY)
        });
        let (judge, last_s) = judge;
        if sample.time_s <= *last_s {
            return Vec::new();
        }
        *last_s = sample.time_s;
        match judge.push(sample) {
            Ok(()) if judge.count().is_multiple_of(EVERY) => sentences(judge, false),
            _ => Vec::new(),
        }
    }

    /// The doubts at the end of the flight that were not given before.
    pub fn end(&mut self) -> Vec<String> {
        self.judge.as_mut().map_or(Vec::new(), |(judge, _)| sentences(judge, true))
    }
}

fn sentences(judge: &mut Judge, at_end: bool) -> Vec<String> {
    let sentence = |finding: sins::judge::Finding| format!("truth: {}", finding.with_remedy());
    judge.new_doubts(at_end).map(sentence).collect()
}
