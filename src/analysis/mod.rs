//! What a flight costs and what its errors come from: the cheapest options that meet an accuracy, the share of each
//! effect, and the errors of real sensors from a record.

pub mod budget;
#[cfg(feature = "identify")]
pub mod identify;
pub mod recommend;
