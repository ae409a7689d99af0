//! The model description: modelDescription.xml.

use std::collections::BTreeMap;
use std::io;

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};

use crate::logger::Category;
use crate::values::{Base, Value};
use crate::variable::{Role, Variable};

/// File name of the binaries.
const MODEL_IDENTIFIER: &str = "sins_fmu";

type Xml = Writer<Vec<u8>>;

type Variables = [(Variable, usize)];

/// Text of the whole file.
pub fn xml(variables: &Variables, guid: &str) -> String {
    xml_of(variables, guid).unwrap_or_default()
}

/// Identity of the unit: a hash of the rest of the description, so that another table gives another identity.
pub fn guid(variables: &Variables) -> String {
    let text = xml(variables, "");
    let half = |basis: u64| {
        // FNV-1a.
        text.bytes().fold(basis, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3))
    };
    let (a, b) = (half(0xcbf2_9ce4_8422_2325), half(0x8422_2325_cbf2_9ce4));
    let digits = format!("{a:016x}{b:016x}");
    let parts = [&digits[..8], &digits[8..12], &digits[12..16], &digits[16..20], &digits[20..]];
    format!("{{{}}}", parts.join("-"))
}

fn xml_of(all: &Variables, guid: &str) -> io::Result<String> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    xml.create_element("fmiModelDescription")
        .with_attribute(("fmiVersion", "2.0"))
        .with_attribute(("modelName", "sins"))
        .with_attribute(("guid", guid))
        .with_attribute((
            "description",
            "Strapdown inertial navigation system: signal generator, sensor errors, mechanization, errors of the navigation",
        ))
        .with_attribute(("version", env!("CARGO_PKG_VERSION")))
        .with_attribute(("license", "MIT OR Apache-2.0"))
        .with_attribute(("generationTool", "sins"))
        .with_attribute(("variableNamingConvention", "structured"))
        .with_attribute(("numberOfEventIndicators", "0"))
        .write_inner_content(|xml| {
            co_simulation(xml)?;
            units(xml, all)?;
            types(xml, all)?;
            categories(xml)?;
            xml.create_element("DefaultExperiment")
                .with_attribute(("startTime", "0"))
                .with_attribute(("stopTime", "3600"))
                .with_attribute(("stepSize", "0.01"))
                .write_empty()?;
            variables(xml, all)?;
            structure(xml, all)
        })?;
    Ok(String::from_utf8(xml.into_inner()).unwrap_or_default())
}

fn co_simulation(xml: &mut Xml) -> io::Result<()> {
    let flags = [
        ("canHandleVariableCommunicationStepSize", "true"),
        ("canInterpolateInputs", "false"),
        ("maxOutputDerivativeOrder", "0"),
        ("canRunAsynchronuously", "false"),
        ("canBeInstantiatedOnlyOncePerProcess", "false"),
        ("canNotUseMemoryManagementFunctions", "true"),
        ("canGetAndSetFMUstate", "true"),
        ("canSerializeFMUstate", "true"),
        ("providesDirectionalDerivative", "false"),
    ];
    xml.create_element("CoSimulation")
        .with_attribute(("modelIdentifier", MODEL_IDENTIFIER))
        .with_attributes(flags)
        .write_empty()?;
    Ok(())
}

/// Writes the units of all variables, each once.
fn units(xml: &mut Xml, all: &Variables) -> io::Result<()> {
    let with_unit = all.iter().filter(|(variable, _)| !variable.unit.is_empty());
    let units: BTreeMap<&str, f64> =
        with_unit.map(|(variable, _)| (variable.unit, variable.unit_si)).collect();
    xml.create_element("UnitDefinitions").write_inner_content(|xml| {
        for (name, si) in units {
            xml.create_element("Unit").with_attribute(("name", name)).write_inner_content(|xml| {
                let Some(exponents) = exponents(name) else { return Ok(()) };
                let mut base = xml.create_element("BaseUnit");
                for (symbol, exponent) in ["m", "s", "K", "rad"].into_iter().zip(exponents) {
                    if exponent != 0 {
                        base = base.with_attribute((symbol, exponent.to_string().as_str()));
                    }
                }
                if si != 1.0 {
                    base = base.with_attribute(("factor", number(si).as_str()));
                }
                if name == "deg C" {
                    base = base.with_attribute(("offset", "273.15"));
                }
                base.write_empty()?;
                Ok(())
            })?;
        }
        Ok(())
    })?;
    Ok(())
}

/// Exponents of m, s, K, rad; `None` if they are not whole, or for a unit in brackets.
fn exponents(unit: &str) -> Option<[i32; 4]> {
    let mut sum = [0; 4];
    for (index, factor) in unit.split('/').enumerate() {
        let (name, power) = match factor.strip_suffix(['2', '3']) {
            Some(name) => (name, factor[name.len()..].parse().ok()?),
            None => (factor, 1),
        };
        let power: i32 = if index == 0 { power } else { -power };
        let own = match name {
            "m" | "mm" | "km" => [1, 0, 0, 0],
            "s" | "h" => [0, 1, 0, 0],
            "Hz" => [0, -1, 0, 0],
            "K" | "deg C" => [0, 0, 1, 0],
            "rad" | "deg" | "arcmin" | "arcsec" => [0, 0, 0, 1],
            "g" | "micro-g" | "mGal" => [1, -2, 0, 0],
            "ppm" => [0; 4],
            _ => return None,
        };
        sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += power * own);
    }
    Some(sum)
}

/// Name of the type of an enumeration: the name of the variable without a number in brackets.
fn type_name(variable: &Variable) -> String {
    match variable.name.split_once('[') {
        Some((before, rest)) => format!("{before}{}", rest.split_once(']').map_or("", |(_, behind)| behind)),
        None => variable.name.clone(),
    }
}

fn types(xml: &mut Xml, all: &Variables) -> io::Result<()> {
    let mut done = Vec::new();
    xml.create_element("TypeDefinitions").write_inner_content(|xml| {
        for (variable, _) in all {
            let Some(words) = variable.words else { continue };
            let name = type_name(variable);
            if done.contains(&name) {
                continue;
            }
            xml.create_element("SimpleType").with_attribute(("name", name.as_str())).write_inner_content(
                |xml| {
                    xml.create_element("Enumeration").write_inner_content(|xml| {
                        for (index, word) in words.iter().enumerate() {
                            xml.create_element("Item")
                                .with_attribute(("name", *word))
                                .with_attribute(("value", (index + 1).to_string().as_str()))
                                .write_empty()?;
                        }
                        Ok(())
                    })?;
                    Ok(())
                },
            )?;
            done.push(name);
        }
        Ok(())
    })?;
    Ok(())
}

fn categories(xml: &mut Xml) -> io::Result<()> {
    xml.create_element("LogCategories").write_inner_content(|xml| {
        for category in Category::ALL {
            xml.create_element("Category")
                .with_attribute(("name", category.name()))
                .with_attribute(("description", category.doc()))
                .write_empty()?;
        }
        Ok(())
    })?;
    Ok(())
}

fn variables(xml: &mut Xml, all: &Variables) -> io::Result<()> {
    xml.create_element("ModelVariables").write_inner_content(|xml| {
        for (variable, reference) in all {
            self::variable(xml, variable, *reference)?;
        }
        Ok(())
    })?;
    Ok(())
}

fn variable(xml: &mut Xml, variable: &Variable, reference: usize) -> io::Result<()> {
    let is_real = variable.start.base() == Base::Real;
    let (causality, variability) = match variable.role {
        Role::Input if is_real => ("input", "continuous"),
        Role::Input => ("input", "discrete"),
        Role::Fixed => ("parameter", "fixed"),
        Role::Tunable => ("parameter", "tunable"),
        Role::Output => ("output", if is_real { "continuous" } else { "discrete" }),
    };
    let is_output = variable.role == Role::Output;
    xml.create_element("ScalarVariable")
        .with_attribute(("name", variable.name.as_str()))
        .with_attribute(("valueReference", reference.to_string().as_str()))
        .with_attribute(("description", variable.doc.as_str()))
        .with_attribute(("causality", causality))
        .with_attribute(("variability", variability))
        .write_inner_content(|xml| {
            let (element, start) = match &variable.start {
                Value::Real(value) => ("Real", number(*value)),
                Value::Integer(value) => {
                    (if variable.words.is_some() { "Enumeration" } else { "Integer" }, value.to_string())
                }
                Value::Boolean(value) => ("Boolean", value.to_string()),
                Value::String(value) => ("String", value.clone()),
            };
            let mut kind = xml.create_element(element);
            if variable.words.is_some() {
                kind = kind.with_attribute(("declaredType", type_name(variable).as_str()));
            }
            if !variable.unit.is_empty() {
                kind = kind.with_attribute(("unit", variable.unit));
            }
            if let Some((low, high)) = variable.limits {
                kind = kind
                    .with_attribute(("min", number(low).as_str()))
                    .with_attribute(("max", number(high).as_str()));
            }
            if variable.nominal != 1.0 {
                kind = kind.with_attribute(("nominal", number(variable.nominal).as_str()));
            }
            if !is_output {
                kind = kind.with_attribute(("start", start.as_str()));
            }
            kind.write_empty()?;
            Ok(())
        })?;
    Ok(())
}

/// Writes the outputs. Their dependencies are not stated, so a master assumes that they depend on all inputs.
fn structure(xml: &mut Xml, all: &Variables) -> io::Result<()> {
    let outputs = all.iter().enumerate().filter(|(_, (variable, _))| variable.role == Role::Output);
    let indexes: Vec<String> = outputs.map(|(index, _)| (index + 1).to_string()).collect();
    xml.create_element("ModelStructure").write_inner_content(|xml| {
        for list in ["Outputs", "InitialUnknowns"] {
            xml.create_element(list).write_inner_content(|xml| {
                for index in &indexes {
                    xml.create_element("Unknown").with_attribute(("index", index.as_str())).write_empty()?;
                }
                Ok(())
            })?;
        }
        Ok(())
    })?;
    Ok(())
}

/// The shortest text that reads back to the bit.
fn number(value: f64) -> String {
    format!("{value:?}")
}
