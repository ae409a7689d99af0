//! Packs the unit: `pack-fmu OUT.fmu PLACE=FILE...`, with the places of binaries and licences in the archive, as
//! "binaries/linux64/sins_fmu.so". If OUT has the name "modelDescription.xml", it writes only the model description.

use std::error::Error;
use std::fs;
use std::io::{Cursor, Write};
use std::path::Path;

use sins_fmu::model_description;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// Files of every unit: place in the archive, place in the project's folder.
const FILES: [(&str, &str); 9] = [
    ("documentation/index.html", "apps/fmu/documentation/index.html"),
    ("documentation/licenses/LICENSE-APACHE", "LICENSE-APACHE"),
    ("documentation/licenses/LICENSE-MIT", "LICENSE-MIT"),
    ("model.png", "apps/fmu/documentation/icon.png"),
    ("resources/drone.toml", "c_examples/scenes/drone.toml"),
    ("resources/fighter.toml", "c_examples/scenes/fighter.toml"),
    ("resources/patrol.toml", "c_examples/scenes/patrol.toml"),
    ("resources/resets.toml", "c_examples/scenes/resets.toml"),
    ("resources/trainer.toml", "c_examples/scenes/trainer.toml"),
];

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let out = arguments.next().ok_or("usage: pack-fmu OUT.fmu PLACE=FILE...")?;
    if Path::new(&out).file_name().is_some_and(|name| name == "modelDescription.xml") {
        return Ok(fs::write(&out, model_description())?);
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).ok_or("the project has a folder")?;
    let mut files = vec![("modelDescription.xml".to_owned(), model_description().into_bytes())];
    for (place, source) in FILES {
        files.push((place.to_owned(), read(&root.join(source))?));
    }
    for source in fs::read_dir(root.join("apps/fmu/src"))? {
        let path = source?.path();
        if let Some(name) =
            path.file_name().and_then(|name| name.to_str()).filter(|name| name.ends_with(".rs"))
        {
            files.push((format!("sources/{name}"), read(&path)?));
        }
    }
    for argument in arguments {
        let (place, file) = argument.split_once('=').ok_or(format!("{argument}: expected PLACE=FILE"))?;
        files.push((place.to_owned(), read(Path::new(file))?));
    }
    files.sort();
    files.dedup();
    fs::write(&out, archive(&files)?)?;
    println!("{out}: {} files", files.len());
    Ok(())
}

fn read(path: &Path) -> Result<Vec<u8>, String> {
    fs::read(path).map_err(|error| format!("{}: {error}", path.display()))
}

/// The archive of `files`; it has the same bytes at any time and on any machine.
fn archive(files: &[(String, Vec<u8>)]) -> Result<Vec<u8>, Box<dyn Error>> {
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .last_modified_time(DateTime::default())
        .unix_permissions(0o644);
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in files {
        archive.start_file(name.as_str(), options)?;
        archive.write_all(bytes)?;
    }
    Ok(archive.finish()?.into_inner())
}
