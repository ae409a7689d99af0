//! What accuracy costs: every configuration of the mechanization on scenes that ask different things, with the time it takes
//! and the error it leaves, without sensor errors.
//!
//! The data flow is `command` → `embedded`, `log` → `scene`, `reference` → `matrix` (errors), `timing` (costs), `grades` (what
//! sensors would err) → `survey` → `front` → `records`, `table`, `diagram`.

mod command;
mod configuration;
mod diagram;
mod embedded;
mod front;
mod grades;
mod instructions;
mod log;
mod matrix;
mod records;
mod reference;
mod scene;
mod survey;
mod table;
mod timing;

pub use command::{Order, USAGE, order};

use crate::failure::Failure;
use crate::write;
use embedded::Embedded;
use instructions::Instructions;
use scene::Scene;
use survey::Survey;

/// Surveys the scenes of `order` and writes the files.
pub fn run(order: &Order) -> Result<(), Failure> {
    std::fs::create_dir_all(&order.output)
        .map_err(|error| Failure::of_file(&order.output, &format!("cannot be made: {error}")))?;
    let instructions = match &order.instructions {
        Some(path) => Instructions::read(path)?,
        None => Instructions::default(),
    };
    let (mut surveys, mut courses) = (Vec::new(), Vec::new());
    let scenes = order.scenes.iter().map(|embedded: &&Embedded| embedded.scene(order.effort.duration_s));
    for scene in scenes.chain(order.logs.iter().map(|path| log::scene(path))) {
        let scene: Scene = scene?;
        eprintln!("{}: {}", scene.name, scene.title);
        let (survey, course) = Survey::flown(&scene, &order.effort)?;
        surveys.push(survey);
        courses.push(course);
    }
    eprintln!("timing");
    let costs = timing::costs(&courses, order.effort.rounds)?;
    for (survey, costs) in surveys.iter_mut().zip(costs) {
        survey.set_costs(&costs);
        let path = order.output.join(format!("{}.svg", survey.name));
        write(&path, &diagram::diagram(survey)?)?;
    }
    write(&order.output.join("curve.csv"), &records::points(&surveys, &instructions)?)?;
    write(&order.output.join("scenes.csv"), &records::scenes(&surveys)?)?;
    let table = table::table(&surveys);
    write(&order.output.join("table.md"), &table)?;
    print!("{table}");
    for line in front::dearer_and_worse(&surveys) {
        println!("{line}");
    }
    Ok(())
}
