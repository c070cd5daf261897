// What an output stage always does, for settings that may change at every clock: the times are
// kept, and every pulse that was taken comes out, once, in its direction, and without delay.
//
// The ghosts see only the settings, the pulses taken, step and dir. The asserts that name the
// timers tie the ghosts to them, for the induction.
module step_dir_props #(
    // bits of the timers
    parameter N = 24
) (
    input wire         clk,
    input wire [N-1:0] length,
    input wire [N-1:0] space,
    input wire [N-1:0] setup,
    input wire [N-1:0] hold,
    input wire         pulse,
    input wire         negative
);
    reg first = 1'b1;
    always @(posedge clk) first <= 1'b0;

    wire         ready, step, dir, idle, pending, want, turned;
    wire [N-1:0] timer, guard;

    step_dir #(.T(N)) axis (
        .i_clk(clk), .i_rst(first), .i_length(length), .i_space(space), .i_setup(setup),
        .i_hold(hold), .i_pulse(pulse), .i_negative(negative), .o_ready(ready), .o_step(step),
        .o_dir(dir), .o_idle(idle), .o_pending(pending), .o_want(want), .o_turned(turned),
        .o_timer(timer), .o_guard(guard)
    );

    // The clock before this one, and its settings.
    reg         was_step, was_dir;
    reg [N-1:0] length_then, space_then, setup_then, hold_then;
    always @(posedge clk) begin
        was_step    <= ~first & step;
        was_dir     <= ~first & dir;
        length_then <= length;
        space_then  <= space;
        setup_then  <= setup;
        hold_then   <= hold;
    end

    wire rises = step & ~was_step;
    wire falls = ~step & was_step;
    wire turns = dir != was_dir;

    // How long step has been as it is and dir as it is, with this clock (counting stops at 2^N,
    // more than any setting), and what the settings asked for when that began. After a reset
    // nothing has been asked for.
    reg  [N:0]   level = 0, steady = 0;
    wire [N:0]   level_now  = rises | falls ? 1 : more(level);
    wire [N:0]   steady_now = turns ? 1 : more(steady);
    reg  [N-1:0] high = 0, low = 0, setup_due = 0, hold_due = 0;
    wire [N-1:0] high_now  = rises ? at_least_one(length_then) : high;
    wire [N-1:0] low_now   = falls ? at_least_one(space_then) : low;
    wire [N-1:0] setup_now = turns ? at_least_one(setup_then) : setup_due;
    wire [N-1:0] hold_now  = falls ? at_least_one(hold_then) : hold_due;
    always @(posedge clk) begin
        level     <= first ? 0 : level_now;
        steady    <= first ? 0 : steady_now;
        high      <= first ? 0 : high_now;
        low       <= first ? 0 : low_now;
        setup_due <= first ? 0 : setup_now;
        hold_due  <= first ? 0 : hold_now;
    end

    function [N:0] more(input [N:0] clocks);
        more = clocks[N] ? clocks : clocks + 1'b1;
    endfunction

    function [N-1:0] at_least_one(input [N-1:0] clocks);
        at_least_one = clocks == 0 ? 1 : clocks;
    endfunction

    // Pulses taken and steps made, by direction. With at most one in between, equal counts also
    // mean equal order.
    reg  [7:0] taken_up = 0, taken_down = 0, made_up = 0, made_down = 0;
    wire [7:0] made_up_now   = made_up + {7'd0, rises & ~dir};
    wire [7:0] made_down_now = made_down + {7'd0, rises & dir};
    always @(posedge clk)
        if (first) begin
            taken_up   <= 0;
            taken_down <= 0;
            made_up    <= 0;
            made_down  <= 0;
        end else begin
            taken_up   <= taken_up + {7'd0, pulse & ready & ~negative};
            taken_down <= taken_down + {7'd0, pulse & ready & negative};
            made_up    <= made_up_now;
            made_down  <= made_down_now;
        end

    // What every time allows now must have happened in the next clock.
    reg must_step = 1'b0, must_turn = 1'b0;
    always @(posedge clk) begin
        must_step <= ~first & ~step & pending & dir == want & level_now >= low_now
            & steady_now >= setup_now;
        must_turn <= ~first & ~step & pending & dir != want & level_now >= hold_now;
    end

    always @* if (!first) begin
        // The four times: high exactly, low at least; dir stands before, during and after a step.
        if (falls) assert (level == high);
        if (rises) assert (level >= low);
        if (rises) assert (steady >= setup_due & ~turns);
        if (turns) assert (~step & ~was_step & level >= hold_due);

        // Nothing lost, nothing repeated, and in its direction.
        assert (taken_up == made_up_now + {7'd0, pending & ~want});
        assert (taken_down == made_down_now + {7'd0, pending & want});
        assert (ready == ~pending);
        assert (idle == (~pending & ~step));

        // Nothing waits longer than the times ask for.
        if (must_step) assert (step);
        if (must_turn) assert (turns);

        // The timers are what is left of the times.
        if (step) assert (level_now + {1'b0, timer} == high_now);
        else assert (timer == 0 ? level_now >= low_now : level_now + {1'b0, timer} == low_now);
        if (~step & ~turned)
            assert (guard == 0 ? level_now >= hold_now : level_now + {1'b0, guard} == hold_now);
        if (turned) assert (pending & ~step & dir == want);
        if (turned)
            assert (guard == 0 ? steady_now >= setup_now : steady_now + {1'b0, guard} == setup_now);
        else assert (steady_now >= setup_now);
    end
endmodule
