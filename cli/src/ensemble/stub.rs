//! The scene's plans over time for an ensemble, until the library has them.

use sins::Error;
use sins::ensemble::Ensemble;
use sins::scene::Scene;
use sins::truth::FlightSample;

pub trait Prepare {
    fn prepare_ensemble(&self, e: &mut Ensemble, start_s: f64, s: &mut FlightSample) -> Result<(), Error>;
}
impl Prepare for Scene {
    fn prepare_ensemble(&self, _: &mut Ensemble, start_s: f64, s: &mut FlightSample) -> Result<(), Error> {
        if let Some(t) = &self.temperature {
            s.temperature_c = Some(t.at(s.time_s - start_s));
        }
        Ok(())
    }
}
