//! What a flight costs and what its errors come from: the cheapest options that meet an accuracy, and the share of each effect.

pub mod budget;
pub mod recommend;
