//! Which effects matter: the error budget of scenes, as bar charts and tables.
//!
//! The data flow is `command` → `grade`, `scene` → `survey` → `chart`, `document`, `table`, `records`.

mod chart;
mod command;
mod document;
mod grade;
mod records;
mod scene;
mod survey;
mod table;

pub use command::{Order, USAGE, order};

use crate::failure::Failure;
use crate::write;
use survey::Survey;

/// Surveys the scenes of `order` and writes the files.
pub fn run(order: &Order) -> Result<(), Failure> {
    std::fs::create_dir_all(&order.output)
        .map_err(|error| Failure::of_file(&order.output, &format!("cannot be made: {error}")))?;
    let surveys = Survey::of_all(&order.asks)?;
    for survey in &surveys {
        write(&order.output.join(format!("{}.svg", survey.name)), &document::picture(survey))?;
    }
    write(&order.output.join("budget.html"), &document::page(&surveys))?;
    write(&order.output.join("budget.csv"), &records::records(&surveys)?)?;
    let tables = table::tables(&surveys);
    write(&order.output.join("table.md"), &tables)?;
    print!("{tables}");
    Ok(())
}
