//! `do` loops with `continue`, which goes on to their condition.
//!
//! The front end goes on to the start of the loop. So they become `for` loops, whose condition holds before the first turn.

use super::circuit::group;
use crate::intake::Complaint;
use crate::intake::token::Token;

/// The tokens of a function's body with such loops rewritten; `None` where there is none.
pub(super) fn with_conditions(body: &[Token]) -> Result<Option<Vec<Token>>, Complaint> {
    if !(body.iter().any(|t| t.is("do")) && body.iter().any(|t| t.is("continue"))) {
        return Ok(None);
    }
    let mut out = Vec::with_capacity(body.len());
    write(body, &mut out)?;
    Ok(Some(out))
}

fn write(tokens: &[Token], out: &mut Vec<Token>) -> Result<(), Complaint> {
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        at += 1;
        if !token.is("do") {
            out.push(token.clone());
            continue;
        }
        let behind = &tokens[at..];
        let Some(length) = group(behind).filter(|_| behind[0].is("{")) else {
            let statement = behind.split(|t| t.is(";")).next().unwrap_or_default();
            if let Some(word) = statement.iter().find(|t| t.is("continue")) {
                let message =
                    "'continue' in a 'do' loop without braces is not there: write 'do { … } while (…);'";
                return Err(Complaint::unsupported(message, word.origin));
            }
            out.push(token.clone());
            continue;
        };
        let (body, rest) = behind.split_at(length);
        let condition = match rest {
            [word, condition @ ..] if word.is("while") => group(condition).map(|n| &condition[..n]),
            _ => None,
        };
        let Some(condition) = condition.filter(|_| body.iter().any(|t| t.is("continue"))) else {
            out.push(token.clone());
            continue;
        };
        let generated = |text: &str| token.renamed(text);
        out.push(generated("for (bool glanz_first = true; glanz_first ? true :"));
        write(condition, out)?;
        out.push(generated("; glanz_first = false)"));
        write(body, out)?;
        // The body, `while`, the condition, and the ';' behind it.
        at += length + 1 + condition.len();
        at += usize::from(tokens.get(at).is_some_and(|t| t.is(";")));
    }
    Ok(())
}
