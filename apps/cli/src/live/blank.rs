//! The files of a flight that has not begun. No flight takes the place of another: it cannot be flown again.

use std::path::PathBuf;

use super::log::Log;
use crate::drawing::document::PAGE_MARK;
use crate::failure::Failure;
use crate::fly::{Files, LONGEST, MARK, UNIT_COLUMNS, UnitFiles};
use crate::given::Given;
use crate::output::{OutputFile, Outputs, numbered};
use crate::places::below;
use sins::record::COLUMNS;

/// Where a session writes.
pub struct Names {
    pub folder: PathBuf,
    pub name: String,
    /// The log, if there is one.
    pub log: Option<PathBuf>,
}

impl Names {
    /// `record` is the name of the log in the folder.
    pub fn new(folder: PathBuf, name: String, record: Option<&str>) -> Result<Self, Failure> {
        let log = record.map(|record| {
            let path = below(&folder, record, "--record", "--record")?;
            match path.extension().is_some_and(|ending| ending == "csv") {
                true => Ok(path),
                false => Err(Failure::new(format!("--record {record}: expected a name that ends in .csv"))),
            }
        });
        let names = Self { log: log.transpose()?, folder, name };
        let own = [".csv", "_summary.csv", "_unit.csv"].map(|ending| names.file(1, ending));
        match &names.log {
            Some(log) if own.contains(log) => {
                Err(Failure::new(format!("--record: {}: two outputs have this name", log.display())))
            }
            _ => Ok(names),
        }
    }

    fn name(&self, number: u64) -> String {
        if number == 1 { self.name.clone() } else { format!("{}_{number}", self.name) }
    }

    /// A file of flight `number`.
    fn file(&self, number: u64, ending: &str) -> PathBuf {
        self.folder.join(format!("{}{ending}", self.name(number)))
    }
}

/// Files of a flight that has not begun.
pub struct Blank {
    /// The number in the names of its files, from 1.
    pub number: u64,
    pub name: String,
    pub files: Files,
    pub summary: OutputFile,
    pub log: Option<Log>,
    /// The page of the session, if it is wanted.
    pub page: Option<OutputFile>,
}

impl Blank {
    /// The files of the next flight, under the first number from `first` on that no other flight has.
    pub fn open(
        given: &Given,
        outputs: &mut Outputs,
        names: &Names,
        first: u64,
        with_page: bool,
    ) -> Result<Self, Failure> {
        outputs.folder(&names.folder)?;
        if let Some(log) = &names.log {
            outputs.folder_of(log)?;
        }
        for number in first.. {
            if let Some(blank) = Self::numbered(given, outputs, names, number, with_page)? {
                return Ok(blank);
            }
        }
        Err(Failure::new(format!("{}: every number is taken", names.name)))
    }

    /// The files of flight `number`; `None`: another flight has one of their names.
    fn numbered(
        given: &Given,
        outputs: &mut Outputs,
        names: &Names,
        number: u64,
        with_page: bool,
    ) -> Result<Option<Self>, Failure> {
        let log = match &names.log {
            None => None,
            Some(path) => match Log::open(outputs, &numbered(path, number))? {
                None => return Ok(None),
                log => log,
            },
        };
        let mut file = |ending: &str, mark: &str| outputs.new_file(&names.file(number, ending), mark);
        let Some(records) = file(".csv", &COLUMNS.join(","))? else { return Ok(None) };
        let Some(mut summary) = file("_summary.csv", MARK)? else { return Ok(None) };
        summary.reserve(LONGEST)?;
        let mut unit = None;
        if given.scene.unit.start.is_some() {
            let Some(file) = file("_unit.csv", &UNIT_COLUMNS.join(","))? else { return Ok(None) };
            unit = Some(UnitFiles::new(Some(file), None)?);
        }
        let mut page = None;
        if with_page {
            page = file(".html", PAGE_MARK)?;
            if page.is_none() {
                return Ok(None);
            }
        }
        let files = Files { records, imu: None, unit };
        Ok(Some(Self { number, name: names.name(number), files, summary, log, page }))
    }
}
