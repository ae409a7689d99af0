//! The title of what is flown. A title is free text, so it may speak of all that its scene sets: it is said only if that is flown.

use sins::scene::{FlightSource, Samples, Scene, Source, builtin};

use crate::units::time_text;

/// Sections of which no title speaks, and that of the flight, which is compared as a whole.
const UNSPOKEN: [&str; 5] = ["options", "output", "log", "imu", "flight"];

/// Title of `scene`, of which `samples` are flown: its own, if the scene of its text, `titled`, is flown (`None`: it is the scene itself);
/// otherwise one that is made from the flight.
pub fn title(scene: &Scene, titled: Option<&Scene>, source: &Source, samples: &Samples) -> String {
    let own = match titled {
        None => Some(scene.title.clone()),
        Some(own) if holds(scene, own) => {
            let whole_s = match (own.duration_s, source) {
                (None, Source::Log(log)) => {
                    let samples = log.samples();
                    samples.last().map_or(0.0, |last| last.time_s - samples[0].time_s)
                }
                (Some(duration_s), Source::Log(_)) => duration_s,
                _ => own.flown_s().unwrap_or(samples.duration_s),
            };
            let flown_s = samples.duration_s;
            // The title may have the hours that its text sets.
            Some(match flown_s > whole_s + samples.period_s {
                true => format!("\"{}\", flown for {}", scene.title, time_text(flown_s)),
                false => part(samples, whole_s, &scene.title),
            })
        }
        Some(_) => None,
    };
    if let Some(own) = own.filter(|_| !scene.title.is_empty()) {
        return own;
    }
    match (source, &scene.flight) {
        (Source::Log(log), _) if log.title.is_empty() => "recorded flight".to_owned(),
        (Source::Log(log), _) => log.title.clone(),
        (_, FlightSource::Builtin(name)) => match builtin(name).filter(|own| flies(scene, own)) {
            Some(own) => part(samples, own.flown_s().unwrap_or(0.0), &own.title),
            None => format!("Flight of {name} (built in)"),
        },
        (_, FlightSource::Path(path)) => match path.manoeuvres.len() * path.repeat {
            1 => "Flight of 1 manoeuvre".to_owned(),
            count => format!("Flight of {count} manoeuvres"),
        },
        (_, FlightSource::Log(_)) => scene.title.clone(),
    }
}

/// Whether the title of `own` may be that of `scene`, whatever its duration.
pub fn holds(scene: &Scene, own: &Scene) -> bool {
    scene.flight == own.flight && flies(scene, own)
}

/// Whether all that `own` sets beside its flight is that of `scene`, each section as a whole.
fn flies(scene: &Scene, own: &Scene) -> bool {
    let keys = [own, scene].map(Scene::changed_keys);
    let of = |place: usize, section: &str| {
        let keys = keys[place].iter().filter(|key| key.section == section);
        keys.map(|key| (key.name, key.value.as_str())).collect::<Vec<_>>()
    };
    let spoken = keys[0].iter().map(|key| key.section).filter(|section| !UNSPOKEN.contains(section));
    spoken.into_iter().all(|section| of(0, section) == of(1, section))
        && (own.temperature.is_none() || own.temperature == scene.temperature)
        && (own.failures.is_empty() || own.failures == scene.failures)
        && (own.updates.is_empty() || own.updates == scene.updates)
        && (own.panel.is_empty() || own.panel == scene.panel)
}

/// The title of a flight of `whole_s`, and whether it is not flown to its end.
fn part(flown: &Samples, whole_s: f64, title: &str) -> String {
    // Whole sampling intervals are flown.
    match flown.duration_s + flown.period_s < whole_s {
        true => format!("The first {} of \"{title}\"", time_text(flown.duration_s)),
        false => title.to_owned(),
    }
}
