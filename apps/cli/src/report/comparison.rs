//! Tables of the rows of the summaries, whatever rows these have.

use maud::{Markup, html};

use crate::drawing::document::table;
use crate::report::run::Run;
use crate::report::summary::Row;

/// Rows in which the runs differ, with a column for each run; then the rows that are the same in all runs.
pub fn comparison(runs: &[Run]) -> Markup {
    let mut rows: Vec<&Row> = Vec::new();
    for row in runs.iter().flat_map(|run| &run.summary.rows) {
        if row.key != "name" && !rows.iter().any(|known| known.key == row.key) {
            rows.push(row);
        }
    }
    let (same, different): (Vec<_>, Vec<_>) = rows
        .into_iter()
        .partition(|row| runs.iter().all(|run| run.summary.value(&row.key) == Some(row.value.as_str())));
    let mut heads = vec!["Quantity".to_owned()];
    heads.extend(runs.iter().map(|run| run.name.clone()));
    let cells = |row: &Row| html! { @for run in runs { (cell(run.summary.row(&row.key))) } };
    let compared = |row: &Row| (html! { (row.title()) }, cells(row));
    html! {
        section {
            h2 { "All runs compared" }
            details {
                summary { "Settings and figures of all runs" }
                // The table is inside the details, so that a link to the table opens them.
                div.table id="comparison" tabindex="0" {
                    (table(Some("comparison"), heads, different.into_iter().map(compared)))
                }
                @if !same.is_empty() {
                    h3 { "The same in all runs" }
                    (list(&same))
                }
            }
        }
    }
}

fn cell(row: Option<&Row>) -> Markup {
    match row {
        Some(row) if row.value.parse::<f64>().is_ok() => {
            html! { td.number title=(row.value) { (row.text()) } }
        }
        Some(row) => html! { td { (row.text()) } },
        None => html! { td { "–" } },
    }
}

/// Label and value of each row.
pub fn list(rows: &[&Row]) -> Markup {
    table(Some("list"), Vec::new(), rows.iter().map(|row| (html! { (row.title()) }, cell(Some(row)))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::run::tests::made;

    #[test]
    fn what_is_the_same_is_reported_once() {
        let mut runs = [made(3, |_, _| 0.0), made(3, |_, _| 0.0)];
        runs[1].summary.rows[1].value = "2".into();
        for run in &mut runs {
            run.summary.rows.push(Row::made("random seed", "7", ""));
        }
        let html = comparison(&runs).into_string();
        let (different, same) = html.split_once("The same in all runs").unwrap();
        assert!(different.contains("1.234 km") && different.contains("2 m"));
        assert!(!different.contains("random seed") && same.contains("random seed"));
    }
}
