//! Numbers with units, as people write them into tags.

/// The first of some numbers.
pub(super) fn number(text: &str) -> Option<f64> {
    text.split(';').next()?.trim().replace(',', ".").parse::<f64>().ok().filter(|n| n.is_finite())
}

/// A length: metres without a unit, with `m`, or feet as `12'` or `12 ft`.
pub(super) fn metres(text: &str) -> Option<f64> {
    let text = text.trim();
    let digits: String = text.chars().take_while(|c| c.is_ascii_digit() || matches!(c, '.' | ',' | '-')).collect();
    let value = number(&digits)?;
    let feet = text[digits.len()..].trim_start().starts_with(['\'', 'f']);
    Some(if feet { value * 0.3048 } else { value }).filter(|metres| (0.0..=1000.0).contains(metres))
}

/// A speed limit, metres per second: kilometres an hour without a unit, miles with one, or the zone.
pub(super) fn speed(text: &str) -> Option<f64> {
    let number: String = text.chars().take_while(|c| c.is_ascii_digit() || *c == '.').collect();
    let speed: f64 = match (number.parse(), text) {
        (Ok(speed), _) => speed,
        (_, "walk") => 6.0,
        (_, "none") => 130.0,
        (_, zone) if zone.ends_with(":urban") => 50.0,
        (_, zone) if zone.ends_with(":rural") => 90.0,
        (_, zone) if zone.ends_with(":living_street") => 7.0,
        _ => return None,
    };
    let kilometres = if text.ends_with("mph") { speed * 1.609_344 } else { speed };
    (1.0..=400.0).contains(&kilometres).then_some(kilometres / 3.6)
}
