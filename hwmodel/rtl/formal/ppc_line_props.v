// What a point-by-point line always does: every end point, every pattern of the pulse source.
module ppc_line_props #(
    parameter N = 24
) (
    input wire         clk,
    input wire         en,
    input wire         load,
    input wire [N-1:0] end_x,
    input wire [N-1:0] end_y,
    input wire [1:0]   negative
);
    reg first = 1'b1;
    always @(posedge clk) first <= 1'b0;

    wire [1:0]   pulse, negative_q, beat, rule;
    wire         done, fx, larger_is_y;
    wire [N:0]   f, e;
    wire [N-1:0] end_x_q, end_y_q, jex, jey;

    // The rule "total", whose counter holds both axes' pulses.
    ppc_line #(.N(N)) line (
        .i_clk(clk), .i_rst(first), .i_en(en), .i_load(load), .i_end_x(end_x), .i_end_y(end_y),
        .i_negative(negative), .i_rule(2'd0), .i_larger_is_y(1'b0),
        .i_e({1'b0, end_x} + {1'b0, end_y}), .o_pulse(pulse), .o_negative(negative_q),
        .o_done(done), .o_rule(rule), .o_larger_is_y(larger_is_y), .o_beat(beat), .o_fx(fx), .o_f(f), .o_end_x(end_x_q), .o_end_y(end_y_q),
        .o_jex(jex), .o_jey(jey), .o_e(e)
    );

    reg [N-1:0] pulses_x = 0, pulses_y = 0;
    always @(posedge clk)
        if (first | load) begin
            pulses_x <= 0;
            pulses_y <= 0;
        end else begin
            pulses_x <= pulses_x + {{(N-1){1'b0}}, pulse[0]};
            pulses_y <= pulses_y + {{(N-1){1'b0}}, pulse[1]};
        end

    // A pulse is counted two beats after it is sent.
    wire           is_sent = beat == 2'd2 | beat == 2'd3;
    wire           is_due  = beat != 2'd0;
    wire [N-1:0]   sent_x  = {{(N-1){1'b0}}, is_sent & fx};
    wire [N-1:0]   sent_y  = {{(N-1){1'b0}}, is_sent & ~fx};
    wire signed [N+1:0] f_wide = {f[N], f};
    wire signed [N+1:0] xe     = {2'b00, end_x_q};
    wire signed [N+1:0] ye     = {2'b00, end_y_q};

    always @* if (!first) begin
        assert (rule == 2'd0);
        assert (!((done | beat != 2'd1) & pulse != 0));
        // Never both axes: one pulse a step.
        assert (pulse != 2'b11);
        // Pulses and counter together are the end point: done means there, exactly.
        assert (pulses_x + jex == end_x_q + sent_x);
        assert (pulses_y + jey == end_y_q + sent_y);
        assert (e == {1'b0, jex} + {1'b0, jey});
        if (done) assert (pulses_x == end_x_q && pulses_y == end_y_q);
        // No more pulses than the end point has.
        assert (jex <= end_x_q && jey <= end_y_q);
        assert (!(is_due & fx) | jex != 0);
        assert (!(is_due & ~fx) | jey != 0);
        // The one-pulse bound, as long as F alone decides: -ye <= F <= xe. (That F then also keeps
        // the axis that is used up from being due is a matter of products, and not claimed here.)
        if (jex != 0 && jey != 0) assert (f_wide >= -ye && f_wide <= xe);
        // Between judging and updating, F's sign is why the axis is due; an axis that is used up
        // is the only other reason.
        if (beat == 2'd1 | beat == 2'd2)
            assert (fx ? (f_wide >= 0 | jey == 0) : (f_wide < 0 | jex == 0));
    end
endmodule
