//! The names of the statuses, for the crate.

use super::model::Interface;

pub fn names(interface: &Interface) -> String {
    let family = interface.enumerations.iter().find(|family| family.name == "sins_status_code");
    let names = family.expect("there are statuses").constants.iter().map(|one| &one.name);
    let arms: String = names.map(|name| format!("        {name} => c\"{name}\",\n")).collect();
    format!(
        "fn name(status: sins_status) -> &'static CStr {{
    match status {{
{arms}        _ => c\"unknown status\",
    }}
}}
"
    )
}
