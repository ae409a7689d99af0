//! Cost of accuracy: computing time and error of every configuration of the mechanization, on scenes that test it in different
//! ways, without sensor errors.
//!
//! The data flow is `command` → `embedded`, `own` → `scene`, `reference` → `matrix` (errors), `timing` (costs), `grades` (errors
//! that sensors would cause) → `survey` → `front` → `records`, `table`, `diagram` (`beside`),
//! `document`.

mod beside;
mod command;
mod configuration;
mod diagram;
mod document;
mod embedded;
mod front;
mod grades;
mod instructions;
mod matrix;
mod own;
mod records;
mod reference;
mod scene;
mod survey;
mod table;
mod timing;

pub use command::Order;

use std::path::PathBuf;

use crate::drawing::document::PAGE_MARK;
use crate::drawing::file::PICTURE_MARK;
use crate::failure::Failure;
use crate::fly::FOR_LOGS;
use crate::given::Given;
use crate::output::Outputs;
use crate::places::svg;
use crate::rows::TABLE_MARK;
use crate::terminal::{print, say};
use crate::written;
use instructions::Instructions;
use scene::Pieces;
use survey::Survey;

/// Surveys the scenes of `order` and writes the files.
pub fn run(order: &Order) -> Result<(), Failure> {
    let effort = order.effort();
    let load = |name| Given::load(Some(name), None, &order.settings, &order.trust, FOR_LOGS);
    let given = order.given.iter().map(|name| load(name)).collect::<Result<Vec<_>, _>>()?;
    given.iter().for_each(Given::say_without_updates);
    let instructions = match &order.instructions {
        Some(path) => Instructions::read(path)?,
        None => Instructions::default(),
    };
    let inputs = given.iter().flat_map(|given| given.inputs.clone()).chain(order.instructions.clone());
    let inputs: Vec<PathBuf> = inputs.collect();
    let embedded = order.embedded();
    let mut outputs = Outputs::new(&inputs, order.force);
    outputs.folder(&order.out)?;
    let mut file = |name: &str, mark: &str| outputs.file(&order.out.join(name), mark);
    let page = file("curve.html", PAGE_MARK)?;
    let points_file = file("curve.csv", &records::POINTS.join(","))?;
    let scenes_file = file("scenes.csv", &records::SCENES.join(","))?;
    let table_file = file("table.md", TABLE_MARK)?;
    let names =
        embedded.iter().map(|embedded| embedded.name).chain(given.iter().map(|given| given.name.as_str()));
    let pictures = names.map(|name| file(&svg(name)?, PICTURE_MARK));
    let pictures = pictures.collect::<Result<Vec<_>, _>>()?;
    let own = [&page, &table_file, &points_file, &scenes_file].into_iter().chain(&pictures);
    let paths: Vec<PathBuf> = own.map(|file| file.path().to_owned()).collect();

    let (mut surveys, mut works) = (Vec::new(), Vec::new());
    let scenes = embedded.iter().map(|embedded| embedded.scene(effort.duration_s).map(Pieces::whole));
    for pieces in scenes.chain(given.iter().map(|given| own::scene(given, &effort))) {
        let pieces: Pieces = pieces?;
        if let Some(scene) = pieces.scenes.first() {
            say(&format!("{}: {}{}", scene.name, scene.title, pieces.text()));
        }
        let (survey, work) = Survey::flown(&pieces, &effort)?;
        surveys.push(survey);
        works.push(work);
    }
    let costs = timing::costs(&works, effort.rounds)?;
    let mut finished = Vec::new();
    for ((survey, costs), picture) in surveys.iter_mut().zip(costs).zip(pictures) {
        survey.set_costs(&costs);
        front::mark(&mut survey.points);
        finished.push(picture.finish(diagram::diagram(survey)?));
    }
    let table = table::table(&surveys);
    let notes = front::costlier_and_less_accurate(&surveys)
        .iter()
        .map(|line| format!("{line}\n"))
        .collect::<String>();
    finished.extend([
        page.finish(document::page(&surveys)?),
        points_file.finish(records::points(&surveys, &instructions)?),
        scenes_file.finish(records::scenes(&surveys)?),
        table_file.finish(format!("{TABLE_MARK}\n\n{table}")),
        print(&(table + &notes)),
    ]);
    Failure::each(finished)?;
    let next = "`sins recommend SCENE --position METRES` chooses the options of a scene";
    print(&written::text(&paths, Some(next)))
}
