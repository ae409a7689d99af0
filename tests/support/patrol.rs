//! The patrol of the paper's simulations, with added angular oscillations.

use sins::Error;
use sins::truth::flight::{Channel, Flight, FlightStart, Manoeuvre, Sinusoid, Sinusoids};

/// Figure-eights of sums of sinusoids, at 200 m/s with banks to 30°, in which the aircraft rolls, pitches and yaws within seconds.
/// It is livelier than the built-in scene `patrol`, which climbs, gains speed and rocks more slowly.
pub fn patrol_from(start: &FlightStart, duration_s: f64) -> Result<Flight, Error> {
    let term = |channel, amplitude, period_s: f64| Sinusoid {
        channel,
        amplitude,
        frequency_hz: 1.0 / period_s,
        phase_rad: 0.0,
    };
    let terms = [
        // The first zero of the Bessel function J0: the oscillation of the course closes to figure-eights.
        term(Channel::Course, 2.404_825_557_695_773, 560.0),
        term(Channel::Climb, 0.02, 217.0),
        term(Channel::Speed, 5.0, 143.0),
        term(Channel::Roll, 0.004, 3.1),
        term(Channel::Pitch, 0.002, 2.3),
        term(Channel::Heading, 0.002, 4.7),
    ];
    Flight::new(
        start,
        &[Manoeuvre::Sinusoids { duration_s, ramp_s: 600.0, sinusoids: Sinusoids::of(&terms) }],
    )
}
