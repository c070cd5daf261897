// The output stage of one axis: pulses become the step and direction signals of a drive.
//
//            |<-length->|<-------space------>|          settings, in clocks
//             __________                      _____
//   step  ___|          |____________________|
//         _______________________ ___________________
//   dir   _______________________X___________________
//                       |<-hold->|<--setup-->|
//
// A pulse waits in a slot of its own until the drive may see it; the slot is free again as soon as
// step rises, so the next pulse can come while this one is still on the wire. A phase takes the
// setting of the clock whose edge begins it; hold counts from the last step.
//
// A reset takes step and dir back at once and knows no times: hold it for the longest of them.
module step_dir #(
    parameter T = 16
) (
    input  wire         i_clk,
    input  wire         i_rst,
    // settings, in clocks; 0 acts as 1
    input  wire [T-1:0] i_length,
    input  wire [T-1:0] i_space,
    input  wire [T-1:0] i_setup,
    input  wire [T-1:0] i_hold,
    // a pulse and its direction, taken when ready, else lost
    input  wire         i_pulse,
    input  wire         i_negative,
    output wire         o_ready,
    // to the drive
    output reg          o_step,
    output reg          o_dir,
    // no pulse waits and step is low
    output wire         o_idle,
    // registers: the slot and its direction; dir has changed for the pulse in the slot; clocks
    // left of length or space; clocks left of setup or hold
    output reg          o_pending,
    output reg          o_want,
    output reg          o_turned,
    output reg  [T-1:0] o_timer,
    output reg  [T-1:0] o_guard
);
    assign o_ready = ~o_pending;
    assign o_idle  = ~o_pending & ~o_step;

    wire timer_is_out = o_timer == 0;
    wire guard_is_out = o_guard == 0;
    wire waits        = o_pending & ~o_step;
    wire agrees       = o_dir == o_want;

    // Before dir turns the guard is that of hold, which only a turn has to respect; then it is
    // that of setup, which only a step has to.
    wire falls = o_step & timer_is_out;
    wire rises = waits & agrees & timer_is_out & (~o_turned | guard_is_out);
    wire turns = waits & ~agrees & guard_is_out;

    // Whether step is high tells which phase can begin, well before it is known that one does.
    wire [T-1:0] phase       = o_step ? i_space : i_length;
    wire [T-1:0] phase_guard = o_step ? i_hold : i_setup;

    // Clocks that are left after one more. The explicit zero keeps the registers without a clock
    // enable, which on an iCE40 would be the slowest path by far.
    function [T-1:0] less(input [T-1:0] clocks);
        less = clocks == 0 ? {T{1'b0}} : clocks - 1'b1;
    endfunction

    always @(posedge i_clk)
        if (i_rst) begin
            o_step    <= 1'b0;
            o_dir     <= 1'b0;
            o_pending <= 1'b0;
            o_want    <= 1'b0;
            o_turned  <= 1'b0;
            o_timer   <= {T{1'b0}};
            o_guard   <= {T{1'b0}};
        end else begin
            if (rises | falls) o_step <= rises;
            if (turns) o_dir <= o_want;
            if (rises | turns) o_turned <= turns;
            o_timer <= rises | falls ? less(phase) : less(o_timer);
            o_guard <= turns | falls ? less(phase_guard) : less(o_guard);

            if (o_ready) begin
                o_pending <= i_pulse;
                if (i_pulse) o_want <= i_negative;
            end else if (rises)
                o_pending <= 1'b0;
        end
endmodule
