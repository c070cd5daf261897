// What a rate multiplier always does; and by unrolling at a narrow width, the number of pulses.
module brm_line_props #(
    parameter N = 24
) (
    input wire           clk,
    input wire           en,
    input wire           load,
    input wire [2*N-1:0] value
);
    reg first = 1'b1;
    always @(posedge clk) first <= 1'b0;

    wire [1:0]     pulse, negative;
    wire           done, tg, overflow;
    wire [N-1:0]   divider, stages;
    wire [2*N-1:0] value_q;

    brm_line #(.N(N), .AXES(2)) line (
        .i_clk(clk), .i_rst(first), .i_en(en), .i_load(load), .i_value(value),
        .i_negative(2'b00), .o_pulse(pulse), .o_negative(negative), .o_done(done), .o_tg(tg),
        .o_divider(divider), .o_value(value_q), .o_stages(stages), .o_overflow(overflow)
    );

    reg [N:0] clocks = 0;
    always @(posedge clk)
        if (first | load) clocks <= 0;
        else if (en & tg) clocks <= clocks + 1'b1;

    reg was_loaded = 1'b0;
    always @(posedge clk) if (first) was_loaded <= 1'b0; else if (load) was_loaded <= 1'b1;

    always @* if (!first) begin
        assert (!((done | ~en) & pulse != 0));
        // At most one stage passes a clock: the trains are disjoint.
        assert ((stages & (stages - 1'b1)) == 0);
        // A clock passes a stage or overflows the divider, never both.
        if (tg) assert ((stages != 0) ^ overflow);
        // Done after exactly 2^N clocks.
        assert (divider == clocks[N-1:0]);
        if (was_loaded) assert (tg == ~clocks[N]);
        if (was_loaded & done) assert (clocks == {1'b1, {N{1'b0}}});
        if (!was_loaded) assert (!tg & clocks == 0);
    end
endmodule
