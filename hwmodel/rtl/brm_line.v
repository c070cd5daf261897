// Straight line by binary rate multiplication: one divider chain, gated by each axis' value.
//
// i_load is SD: it clears the divider and sets TG. TG opens the gate for the source clocks; the
// divider's overflow resets it.
module brm_line #(
    parameter N    = 24,
    parameter AXES = 2
) (
    input  wire              i_clk,
    input  wire              i_rst,
    // pulse source
    input  wire              i_en,
    // command
    input  wire              i_load,
    input  wire [AXES*N-1:0] i_value,
    input  wire [AXES-1:0]   i_negative,
    // pulses of this clock, and their directions
    output wire [AXES-1:0]   o_pulse,
    output reg  [AXES-1:0]   o_negative,
    output wire              o_done,
    // registers, and the stage that passes this clock (stage 0 is the fastest)
    output reg               o_tg,
    output reg  [N-1:0]      o_divider,
    output reg  [AXES*N-1:0] o_value,
    output wire [N-1:0]      o_stages,
    output wire              o_overflow
);
    // The flip-flop of the divider that is about to rise: the lowest one that is clear.
    wire [N:0] next   = {1'b0, o_divider} + 1'b1;
    wire [N:0] rising = next & ~{1'b0, o_divider};

    assign o_stages   = rising[N-1:0] & {N{o_tg}};
    assign o_overflow = rising[N] & o_tg;
    assign o_done     = ~o_tg;

    genvar axis, stage;
    generate
        for (axis = 0; axis < AXES; axis = axis + 1) begin : axes
            // The most significant bit gates the fastest stage.
            wire [N-1:0] gated;
            for (stage = 0; stage < N; stage = stage + 1) begin : gates
                assign gated[stage] = o_stages[stage] & o_value[axis*N + N-1-stage];
            end
            assign o_pulse[axis] = i_en & |gated;
        end
    endgenerate

    always @(posedge i_clk)
        if (i_rst) begin
            o_tg       <= 1'b0;
            o_divider  <= {N{1'b0}};
            o_value    <= {AXES*N{1'b0}};
            o_negative <= {AXES{1'b0}};
        end else if (i_load) begin
            o_tg       <= 1'b1;
            o_divider  <= {N{1'b0}};
            o_value    <= i_value;
            o_negative <= i_negative;
        end else if (i_en & o_tg) begin
            o_divider <= next[N-1:0];
            o_tg      <= ~o_overflow;
        end
endmodule
