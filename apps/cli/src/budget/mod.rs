//! Which effects matter: the error budget of scenes, as bar charts and tables.
//!
//! The data flow is `command` → `scene` → `survey` → `chart`, `document`, `table`, `records`.

mod chart;
mod command;
mod document;
mod records;
mod scene;
mod survey;
mod table;

pub use command::{FOR_LOGS, Order};

use std::path::PathBuf;

use crate::drawing::document::PAGE_MARK;
use crate::drawing::file::PICTURE_MARK;
use crate::failure::Failure;
use crate::given::Given;
use crate::output::Outputs;
use crate::places::svg;
use crate::rows::TABLE_MARK;
use crate::terminal::print;
use crate::written;
use scene::BudgetScene;
use survey::Survey;

/// Surveys the scenes of `order` and writes the files.
pub fn run(order: &Order) -> Result<(), Failure> {
    let request = order.request()?;
    let load = |name| Given::load(Some(name), None, &order.settings, &order.trust, command::FOR_LOGS);
    let given = order.scenes.iter().map(|name| load(name)).collect::<Result<Vec<_>, _>>()?;
    given.iter().for_each(Given::say_left_out);
    let inputs: Vec<PathBuf> = given.iter().flat_map(|given| given.inputs.clone()).collect();
    let scenes: Vec<BudgetScene> =
        given.into_iter().map(|given| BudgetScene::new(given, order.hours * 3600.0)).collect();
    let mut outputs = Outputs::new(&inputs, order.force);
    outputs.folder(&order.out)?;
    let mut file = |name: &str, mark: &str| outputs.file(&order.out.join(name), mark);
    let page = file("budget.html", PAGE_MARK)?;
    let rows = file("budget.csv", &records::COLUMNS.join(","))?;
    let table = file("table.md", TABLE_MARK)?;
    let pictures = scenes.iter().map(|scene| file(&svg(&scene.name)?, PICTURE_MARK));
    let pictures = pictures.collect::<Result<Vec<_>, _>>()?;
    let own = [&page, &rows, &table].into_iter().chain(&pictures);
    let paths: Vec<PathBuf> = own.map(|file| file.path().to_owned()).collect();

    let surveys = Survey::of_all(&scenes, &request, order.time_steps)?;
    let tables = table::tables(&surveys);
    let text = records::records(&surveys)?;
    let drawn = surveys.iter().map(document::picture).collect::<Result<Vec<_>, _>>()?;
    let drawn = drawn.into_iter().zip(pictures).map(|(drawn, picture)| picture.finish(drawn));
    Failure::each(drawn.chain([
        page.finish(document::page(&surveys)?),
        rows.finish(text),
        table.finish(format!("{TABLE_MARK}\n\n{tables}")),
        print(&tables),
    ]))?;
    print(&written::text(&paths, Some(&written::open(&paths[0]))))
}
