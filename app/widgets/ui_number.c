#include "widgets/ui_number.h"

#include <stdio.h>

#include "base/quantity.h"

void ui_number_print(const UiSlider *slider, double value, char *text, size_t size) {
    const char *unit = slider->unit ? slider->unit : "";
    snprintf(text, size, "%.*f%s%s", slider->whole ? 0 : slider->digits, value, *unit ? " " : "", unit);
}

bool ui_number_is_wrong(const UiSlider *slider, const char *text, double *value, char reason[UI_REASON]) {
    char why[QUANTITY_REASON] = "", least[64], most[64];
    double typed;
    bool read = quantity_read(text, slider->unit, &typed, why);
    double slack = 1e-9 * fmax(fabs(slider->least), fabs(slider->most)); /* 1500 mm is 1.5 m, whatever the rounding */
    if (read && slider->whole)
        typed = round(typed);
    if (read && typed >= slider->least - slack && typed <= slider->most + slack) {
        *value = real_clamp(typed, slider->least, slider->most);
        return false;
    }
    ui_number_print(slider, slider->least, least, sizeof least);
    ui_number_print(slider, slider->most, most, sizeof most);
    if (read)
        snprintf(reason, UI_REASON, "%s to %s", least, most);
    else
        snprintf(reason, UI_REASON, "%s to %s; %s", least, most, why);
    return true;
}
