#include "widgets/ui_number.h"

#include <stdio.h>
#include <string.h>

#include "base/quantity.h"

/* Returns the unit; a pure number has none. */
static const char *unit_of(const UiSlider *slider) {
    return slider->unit && strcmp(slider->unit, "1") != 0 ? slider->unit : "";
}

void ui_number_print(const UiSlider *slider, double value, char *text, size_t size) {
    const char *unit = unit_of(slider);
    int digits = slider->whole ? 0 : slider->digits;
    double grain = 0.5 * pow(10, -digits);
    while (slider->digits_least && digits > slider->digits_least &&
           fabs(value - round(value * pow(10, digits - 1)) / pow(10, digits - 1)) < 0.01 * grain)
        digits--;
    snprintf(text, size, "%.*f%s%s", digits, value, *unit ? " " : "", unit);
}

bool ui_number_is_wrong(const UiSlider *slider, const char *text, double *value, char reason[UI_REASON]) {
    char why[QUANTITY_REASON] = "";
    double typed;
    bool read = quantity_read(text, slider->unit, &typed, why);
    double slack = 1e-9 * fmax(fabs(slider->least), fabs(slider->most)); /* 1500 mm is 1.5 m, whatever the rounding */
    if (read && slider->whole)
        typed = round(typed);
    if (read && typed >= slider->least - slack && typed <= slider->most + slack) {
        *value = real_clamp(typed, slider->least, slider->most);
        return false;
    }
    const char *unit = unit_of(slider);
    snprintf(reason, UI_REASON, "%g to %g%s%s%s%s", slider->least, slider->most, *unit ? " " : "", unit,
             read ? "" : "; ", why);
    return true;
}
