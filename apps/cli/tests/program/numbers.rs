//! Values that are no numbers or far too large are rejected with their line, or drawn without NaN and infinity.

use crate::support::{done, numbers, read, rejected, run, with_log};

#[test]
fn no_number_of_a_record_becomes_none_or_infinite_on_a_page() {
    let folder = with_log("numbers");
    done(
        &folder,
        &[
            "fly",
            "logs/mylog.csv",
            "-q",
            "--name",
            "run",
            "--preset",
            "tactical",
            "--set",
            "options.error_model=rk4",
        ],
    );
    let (records, summary) = (folder.join("sins_out/run.csv"), folder.join("sins_out/run_summary.csv"));
    let good = read(&records);
    let (columns, rows) = numbers(&records);
    let with = |value: &str, column: usize, only: Option<usize>| {
        let row = |(k, row): (usize, &Vec<f64>)| {
            let field = |(c, number): (usize, &f64)| {
                let is_it = c == column && only.is_none_or(|only| only == k);
                if is_it { value.to_owned() } else { number.to_string() }
            };
            row.iter().enumerate().map(field).collect::<Vec<_>>().join(",") + "\n"
        };
        format!("{}\n{}", columns.join(","), rows.iter().enumerate().map(row).collect::<String>())
    };
    let page = folder.join("page.html");
    let (mut refused, mut pages) = (0, 0);
    for value in ["1e308", "-1e308", "nan", "inf", "1e30", "-1e30", "5e-324", "1e-60", "-0.0"] {
        for (column, name) in columns.iter().enumerate().skip(1) {
            for only in [Some(3), None] {
                // With one spoiled record, all columns; with all records spoiled, a third of the columns.
                if only.is_none() && column % 3 != 0 {
                    continue;
                }
                std::fs::write(&records, with(value, column, only)).unwrap();
                let (code, _, errors) = run(&folder, &["report", "sins_out/run.csv", "-o", "page.html"]);
                let row = 2 + only.unwrap_or(0);
                let place = format!("sins_out/run.csv:{row}: column {} ({name})", column + 1);
                if code == 2 {
                    assert!(errors.starts_with(&place), "{errors}");
                    refused += 1;
                } else {
                    assert_eq!(code, 0, "{value} in {name}: {errors}");
                    assert_is_finite(&read(&page), &format!("{value} in {name}"));
                    pages += 1;
                }
            }
        }
    }
    std::fs::write(&records, good).unwrap();
    let figures = read(&summary);
    for line in figures.lines().filter(|line| line.split(',').nth(2).is_some_and(|unit| !unit.is_empty())) {
        let fields: Vec<&str> = line.splitn(3, ',').collect();
        for value in ["nan", "inf", "1e308"] {
            let spoiled = format!("{},{value},{}", fields[0], fields[2]);
            std::fs::write(&summary, figures.replace(line, &spoiled)).unwrap();
            let errors = rejected(&folder, &["report", "sins_out/run.csv", "-o", "page.html"]);
            assert!(errors.starts_with("sins_out/run_summary.csv:"), "{errors}");
            refused += 1;
        }
    }
    println!("figure: {refused} rejected with line, {pages} pages without NaN or inf");
}

fn assert_is_finite(page: &str, what: &str) {
    // The marks match numbers, and not words of the style sheet and of the text.
    for mark in ["NaN", "\"inf", " inf ", "inf,", ",inf", "-inf", "nan,", ",nan", "\"nan"] {
        assert!(!page.contains(mark), "{what}: {mark}");
    }
    assert!(page.len() < 4_000_000, "{what}: {} bytes", page.len());
}
