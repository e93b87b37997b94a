# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the wall time of a run went: parts that do not overlap, from the timings of its summary."""

# Label and entry of timings_s, in the order in which they are shown; parts of blocks first.
OF_BLOCKS = (("contact search", "contact_search"), ("springs", "springs"), ("assembly", "assembly"), ("factors", "factors"),
             ("products and sweeps", "products"), ("surface products", "surface_products"))


def parts_of_static_stage(summary):
    """{label: wall time [s]} of the static stage; its rest is that of the bedrock, of planes, motion and balance."""
    timings = summary.get("timings_s") or {}
    found = {label: timings["static_" + key] for label, key in OF_BLOCKS if timings.get("static_" + key)}
    rest = timings.get("static_stage", 0.0) - sum(found.values())
    return dict(found, other=rest) if rest > 0 else found


def parts(summary, minimum=0.0):
    """{label: wall time [s]} of the time loop, less parts below `minimum` of it. Of an older run blocks are one part."""
    timings = summary.get("timings_s") or {}
    found = {}
    if "blocks" in timings:
        inner = {label: timings[key] for label, key in OF_BLOCKS if key in timings}
        is_told = "springs" in timings
        found.update(inner if is_told else {"contact search": timings.get("contact_search", 0.0)})
        found["other of blocks" if is_told else "blocks"] = max(0.0, timings["blocks"] - sum(found.values()))
    factors = timings.get("continuum_factors", 0.0)
    found["bedrock, factors"] = factors
    found["bedrock"] = max(0.0, timings.get("continuum", 0.0) - factors)
    found["output"] = timings.get("output", 0.0)
    total = sum(found.values())
    return {label: seconds for label, seconds in found.items() if total > 0 and seconds > 0 and seconds >= minimum * total}
