//! Reads the data files, in the order of their names.

use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;

use super::rows::{
    BlockFile, Catalogue, CommandFile, FunctionFile, MemoryFile, MessageFile, ModelFile, NumberFile, OperandFile,
    OperatorFile, WordFile,
};

/// Reads everything below a directory. Each error names its file.
pub fn read(data: &Path) -> Result<Catalogue, Vec<String>> {
    let mut catalogue = Catalogue::default();
    for path in directory(&data.join("commands"))? {
        let file: CommandFile = load(&path)?;
        catalogue.commands.extend(file.command.into_iter().map(|mut row| {
            row.group.clone_from(&file.group);
            row
        }));
    }
    for folder in ["parameters", "bits"] {
        for path in directory(&data.join(folder))? {
            let mut file: NumberFile = load(&path)?;
            for row in file.parameter.iter_mut().chain(&mut file.bit) {
                row.object.clone_from(&file.object);
            }
            catalogue.parameters.append(&mut file.parameter);
            catalogue.bits.append(&mut file.bit);
        }
    }
    let operators: OperatorFile = load(&data.join("operators.toml"))?;
    catalogue.operators = operators.operator;
    catalogue.unary_operators = operators.unary;
    catalogue.functions = load::<FunctionFile>(&data.join("functions.toml"))?.function;
    catalogue.operands = load::<OperandFile>(&data.join("operands.toml"))?.operand;
    catalogue.blocks = load::<BlockFile>(&data.join("parameter_blocks.toml"))?.block;
    catalogue.words = load::<WordFile>(&data.join("flag_words.toml"))?.word;
    catalogue.models = load::<ModelFile>(&data.join("models.toml"))?.model;
    catalogue.messages = load::<MessageFile>(&data.join("messages.toml"))?.message;
    catalogue.memory = load::<MemoryFile>(&data.join("memory.toml"))?;
    Ok(catalogue)
}

fn directory(path: &Path) -> Result<Vec<PathBuf>, Vec<String>> {
    let named = |error: std::io::Error| vec![format!("{}: {error}", path.display())];
    let entries = std::fs::read_dir(path).map_err(named)?;
    let mut paths =
        entries.map(|entry| entry.map(|entry| entry.path())).collect::<Result<Vec<_>, _>>().map_err(named)?;
    paths.sort();
    Ok(paths)
}

fn load<T: DeserializeOwned>(path: &Path) -> Result<T, Vec<String>> {
    let text = std::fs::read_to_string(path).map_err(|error| vec![format!("{}: {error}", path.display())])?;
    toml::from_str(&text).map_err(|error| vec![format!("{}: {error}", path.display())])
}
