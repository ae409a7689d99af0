//! The tables of the crate's parameters.

#[path = "../src/sensors/altimeter_table.rs"]
mod altimeter;
#[path = "../src/sensors/gravity_table.rs"]
mod gravity;
#[path = "../src/sensors/initial_table.rs"]
mod initial;
#[path = "../src/signal/mounting/table.rs"]
mod mounting;
#[path = "../src/truth/flight/table.rs"]
mod start;
#[path = "../src/sensors/table.rs"]
mod triad;
#[path = "../src/unit/table.rs"]
mod unit;

pub use altimeter::ALTIMETER;
pub use gravity::GRAVITY;
pub use initial::INITIAL;
pub use mounting::MOUNTING;
pub use start::START;
pub use triad::PARAMETERS;
pub use unit::UNIT;

/// Their files.
pub const FILES: [&str; 7] = [
    "src/sensors/altimeter_table.rs",
    "src/sensors/gravity_table.rs",
    "src/sensors/initial_table.rs",
    "src/sensors/table.rs",
    "src/signal/mounting/table.rs",
    "src/truth/flight/table.rs",
    "src/unit/table.rs",
];
