//! The Python script as a Jupyter notebook, nbformat 4.5.

use serde_json::{Value, json};

use super::python::sections;
use super::study::Study;

/// The notebook.
pub fn notebook(study: &Study) -> Value {
    let mut remarks = format!("# {}\n\n", study.title);
    for remark in &study.remarks {
        remarks += &format!("{remark}\n\n");
    }
    remarks += "SI units and radians. Needs python-control and matplotlib: `pip install control matplotlib`";
    let mut cells = vec![json!({
        "cell_type": "markdown", "id": "about", "metadata": {}, "source": lines(&remarks),
    })];
    for (number, section) in sections(study).into_iter().enumerate() {
        cells.push(json!({
            "cell_type": "markdown", "id": format!("title-{number}"), "metadata": {},
            "source": lines(&format!("## {}", section.title)),
        }));
        cells.push(json!({
            "cell_type": "code", "execution_count": null, "id": format!("code-{number}"), "metadata": {}, "outputs": [],
            "source": lines(section.code.trim_end()),
        }));
    }
    json!({
        "cells": cells,
        "metadata": {
            "kernelspec": { "display_name": "Python 3", "language": "python", "name": "python3" },
            "language_info": { "name": "python" },
        },
        "nbformat": 4,
        "nbformat_minor": 5,
    })
}

/// Lines as a notebook keeps them, each with its end.
fn lines(text: &str) -> Vec<&str> {
    text.split_inclusive('\n').collect()
}
