//! The table of all variables: inputs, parameters, outputs.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError, Weak};

use crate::values::{Base, Values};
use crate::variable::{Role, Variable};
use crate::{corrections, description, inputs, outputs, panel, parameters};

/// All variables, in the order of the model description, with the place of each in its row.
#[derive(Debug)]
pub struct Table {
    pub variables: Vec<(Variable, usize)>,
    pub start: Values,
    /// Identity of the unit.
    pub guid: String,
    by_name: BTreeMap<String, usize>,
}

/// The table of this model. It exists while it is in use, mainly by an instance. A static table would leak memory each time a
/// master unloads the unit.
pub fn table() -> Arc<Table> {
    static SHARED: Mutex<Weak<Table>> = Mutex::new(Weak::new());
    let mut shared = SHARED.lock().unwrap_or_else(PoisonError::into_inner);
    shared.upgrade().unwrap_or_else(|| {
        let table = Arc::new(Table::new());
        *shared = Arc::downgrade(&table);
        table
    })
}

impl Table {
    /// The model description.
    pub fn xml(&self) -> String {
        description::xml(&self.variables, &self.guid)
    }

    fn new() -> Self {
        let mut start = Values::default();
        let inputs =
            inputs::variables().chain(corrections::inputs()).chain(panel::inputs()).chain(inputs::switches());
        let all = inputs.chain(parameters::variables()).chain(outputs::variables());
        let variables: Vec<(Variable, usize)> = all
            .map(|variable| {
                let place = start.push(variable.start.clone());
                (variable, place)
            })
            .collect();
        let names = variables.iter().enumerate();
        let by_name = names.map(|(index, (variable, _))| (variable.name.clone(), index)).collect();
        let guid = description::guid(&variables);
        Self { variables, start, guid, by_name }
    }

    /// The variable of a name, and its place in its row.
    pub fn named(&self, name: &str) -> Option<(&Variable, usize)> {
        let (variable, place) = &self.variables[*self.by_name.get(name)?];
        Some((variable, *place))
    }

    /// The variable at a place of a row.
    pub fn variable(&self, base: Base, place: usize) -> Option<&Variable> {
        let is_it = |(variable, at): &&(Variable, usize)| *at == place && variable.start.base() == base;
        self.variables.iter().find(is_it).map(|(variable, _)| variable)
    }

    /// Variables of a role and their places in their rows.
    pub fn of_role(&self, role: Role) -> impl Iterator<Item = (&Variable, usize)> {
        let of_role = move |(variable, _): &&(Variable, usize)| variable.role == role;
        self.variables.iter().filter(of_role).map(|(variable, place)| (variable, *place))
    }
}
