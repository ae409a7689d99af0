//! Each effect of sensors, mounting, alignment and gravity, against its closed form.

#[path = "../support/mod.rs"]
mod support;

mod alignment;
mod alignment_time;
mod altimeter;
mod every_parameter;
mod failures;
mod grades;
mod gravity_disturbance;
mod in_flight;
mod independence;
mod mounting;
mod noise_statistics;
mod sensor_table;
mod temperature;
mod triad;
