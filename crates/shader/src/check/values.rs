//! Warnings from the IR: it knows which variable a value is.

use std::collections::HashMap;

use naga::{Expression, Function, GlobalVariable, Handle, LocalVariable, MathFunction, Statement};

use crate::intake::{Front, Origin, origin_of};
use crate::lower::Purpose;

/// Outputs to which nothing is ever assigned.
pub(super) fn outputs_never_written(front: &Front) -> Vec<(String, Origin)> {
    let module = &front.module;
    let is_written = |global: Handle<GlobalVariable>| {
        module.functions.iter().any(|(_, f)| writes(f, global))
            || module.entry_points.iter().any(|entry| writes(&entry.function, global))
    };
    let mut all = Vec::new();
    for (handle, global) in module.global_variables.iter() {
        let name = global.name.as_deref().unwrap_or("");
        let Some(Purpose::Output(host)) = front.given.roles.get(name) else { continue };
        let Some(origin) = front.given.declared.get(host).filter(|_| !is_written(handle)) else { continue };
        all.push((
            format!("the output '{host}' is never written: what reads it gets 0 here, anything on a GPU"),
            *origin,
        ));
    }
    all
}

/// Whether a function names a global other than to load from it.
fn writes(function: &Function, global: Handle<GlobalVariable>) -> bool {
    let mut found = false;
    statements(&function.body, &mut |statement| {
        let pointers: &[Handle<Expression>] = match statement {
            Statement::Store { pointer, .. } => std::slice::from_ref(pointer),
            Statement::Call { arguments, .. } => arguments,
            _ => &[],
        };
        found |= pointers.iter().any(|p| root(function, *p) == Some(global));
    });
    found
}

fn root(function: &Function, mut e: Handle<Expression>) -> Option<Handle<GlobalVariable>> {
    loop {
        match function.expressions[e] {
            Expression::Access { base, .. } | Expression::AccessIndex { base, .. } => e = base,
            Expression::GlobalVariable(global) => return Some(global),
            _ => return None,
        }
    }
}

fn statements<'a>(block: &'a naga::Block, f: &mut dyn FnMut(&'a Statement)) {
    for statement in block.iter() {
        f(statement);
        crate::lower::inner_blocks(statement, &mut |inner| statements(inner, f));
    }
}

/// Interpolated normals that stand in a dot product or reflection without having been normalised.
pub(super) fn raw_normals(front: &Front) -> Vec<(String, Origin)> {
    let functions = front.module.functions.iter().map(|(_, f)| f);
    let mut all = Vec::new();
    for function in functions.chain(front.module.entry_points.iter().map(|entry| &entry.function)) {
        let once = stored_once(function);
        for (handle, expression) in function.expressions.iter() {
            let Expression::Math { fun: MathFunction::Dot | MathFunction::Reflect, arg, arg1, .. } =
                expression
            else {
                continue;
            };
            let operands = [Some(*arg), *arg1];
            let normals =
                operands.into_iter().flatten().filter_map(|e| raw_normal(front, function, &once, e));
            let names: Vec<String> = normals.collect();
            // The dot product with itself is the square of its length, and asks for it.
            if let [name] = &names[..]
                && let Some(origin) = [handle, *arg]
                    .into_iter()
                    .find_map(|e| origin_of(function.expressions.get_span(e), &front.map))
            {
                let message = format!(
                    "'{name}' is interpolated between vertices and so is shorter than 1 between them: normalize({name})"
                );
                all.push((message, origin));
            }
        }
    }
    all
}

/// The value that a local variable gets, if it gets only one.
fn stored_once(function: &Function) -> HashMap<Handle<LocalVariable>, Option<Handle<Expression>>> {
    let mut all = HashMap::new();
    statements(&function.body, &mut |statement| {
        if let Statement::Store { pointer, value } = statement
            && let Expression::LocalVariable(local) = function.expressions[*pointer]
        {
            all.entry(local).and_modify(|stored| *stored = None).or_insert(Some(*value));
        }
    });
    all
}

/// The name of the interpolated normal that a value is, as it came.
fn raw_normal(
    front: &Front,
    function: &Function,
    once: &HashMap<Handle<LocalVariable>, Option<Handle<Expression>>>,
    mut e: Handle<Expression>,
) -> Option<String> {
    // A chain of copies is short.
    for _ in 0..8 {
        let Expression::Load { pointer } = function.expressions[e] else { return None };
        if let Expression::LocalVariable(local) = function.expressions[pointer] {
            e = (*once.get(&local)?)?;
            continue;
        }
        let global = root(function, pointer)?;
        let name = front.module.global_variables[global].name.as_deref()?;
        let Some(Purpose::Input(host)) = front.given.roles.get(name) else { return None };
        let lower = host.to_lowercase();
        let is_normal =
            lower.contains("norm") || lower.ends_with("nor") || lower.ends_with('n') && lower.len() < 3;
        let is_flat =
            front.given.ports.get(host).is_some_and(|p| p.interpolation == crate::Interpolation::Flat);
        return (is_normal && !is_flat).then(|| host.clone());
    }
    None
}
