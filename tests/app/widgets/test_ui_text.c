/* Texts of widgets: labels have room, a number stays with its unit, and letters of any script are found. */
#include "check.h"

#include <string.h>

#include "pane.h"

enum { WIDTH = 1280, HEIGHT = 720 };

TEST(no_label_is_cut) {
    static const char *const labels[] = {"Keep", "Clear", "Export...", "open", "closed", "locked"};
    for (int text = 1; text <= 3; text++) {
        Pane pane = pane_begin(WIDTH, HEIGHT, text, THEME_PAPER);
        pane_frame(&pane);
        for (int i = 0; i < 6; i++) { /* three side by side in the panel */
            CHECK(ui_extent(pane.ui, UI_BOLD, labels[i]).x < (312 - 2 * 8) / 3.0 - 8);
            CHECK(ui_extent(pane.ui, UI_BOLD, labels[i]).y < 24);
        }
        CHECK(ui_extent(pane.ui, UI_SMALL, "measure").x < 80);
        pane_end(&pane);
    }
}

TEST(a_number_stays_with_its_unit_at_the_end_of_a_line) {
    static const char text[] = "The doorway has 0.75 m and needs 0.83 m: widen it by 8 cm, which costs 12 s at most.";
    for (double width = 90; width < 400; width += 7) {
        Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
        size_t count;
        ui_begin(pane.ui, &pane.input);
        ui_pane_begin(pane.ui, &(UiPane){.name = "card", .box = {{0, 0}, {width, HEIGHT}}, .ground = ROLE_PAPER});
        ui_text(pane.ui, UI_BODY, ROLE_TEXT, text);
        ui_pane_end(pane.ui);
        ui_end(pane.ui);
        const UiPainted *lines = ui_painted(pane.ui, &count);
        CHECK(count > 1);
        for (size_t i = 0; i + 1 < count; i++) {
            char last = lines[i].text[strlen(lines[i].text) - 1];
            CHECK(last < '0' || last > '9');
        }
        pane_end(&pane);
    }
}

TEST(letters_of_any_script_can_be_asked_for) {
    Pane pane = pane_begin(WIDTH, HEIGHT, 1, THEME_PAPER);
    pane_frame(&pane);
    ui_extent(pane.ui, UI_BODY, "żółć 漢字 \xF0\x9F\x98\x80 \xFF\xC3");
    pane_picture(&pane);
    CHECK(ui_extent(pane.ui, UI_BODY, "ż").x > 0);
    pane_end(&pane);
}
