#[allow(dead_code)]
#[path = "../src/bin/sins_report/allan/estimate/mod.rs"]
mod estimate;
